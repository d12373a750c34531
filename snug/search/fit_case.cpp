#include "snug/search/fit_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/search/extreme_points.h"
#include "snug/search/frames.h"
#include "snug/search/turn.h"
#include "snug/space/fitted_space.h"
#include "snug/space/place_zones.h"

namespace snug {
namespace {

constexpr std::uint64_t kSpread = 6000;  ///< rotations that are looked at all over
constexpr std::size_t kStarts = 5;       ///< of which the best are turned further, for each case tried
constexpr int kTries = 240;              ///< turns from each start
constexpr std::size_t kMostCases = 300;  ///< cases that are tried
constexpr double kHopelessShare = 0.12;  ///< of the object's length, that a start may be too long

struct Sample {
    Turn turn;
    Vec3d lengths;
};

/// Blocks of the walls on both sides of each axis.
Vec3d wall_blocks(const Walls& walls, Vec3d block_mm) {
    Vec3d blocks;
    for (std::size_t side = 0; side < walls.size(); ++side)
        blocks[static_cast<int>(side / 2)] +=
            std::ceil((walls[side] - 1e-9) / block_mm[static_cast<int>(side / 2)]);
    return blocks;
}

/// How long an object is once it is turned. Where its zones keep more free than its clearance does: how long
/// one without zones would be that takes as much of a space with it in the middle.
class TurnedLengths {
  public:
    TurnedLengths(const Mesh& mesh, const CutOptions& cut, const std::vector<ItemZone>& zones)
        : body_(mesh), cut_(cut), zones_(zones) {
        for (const ItemZone& zone : zones) {
            points_.emplace_back();
            if (!zone.surface->mesh.vertices.empty()) points_.back().emplace(zone.surface->mesh);
        }
    }

    [[nodiscard]] Vec3d operator()(const Rotation& rotation) const {
        const Placement lies{rotation, {}, body_.turned(rotation)};
        const Vec3d middle = lies.bounds.centre(), most = most_clearance(cut_);
        Vec3d lengths = lies.bounds.size();
        for (std::size_t i = 0; i < zones_.size(); ++i) {
            const Box3d room = grown(turned(i, lies), zones_[i].clearance_mm(cut_));
            for (int axis = 0; axis < 3; ++axis) {
                const double half = std::max(room.max[axis] - middle[axis], middle[axis] - room.min[axis]);
                lengths[axis] = std::max(lengths[axis], 2 * (half - most[axis]));
            }
        }
        return lengths;
    }
    void add_furthest(const Rotation& rotation) {
        body_.add_furthest(rotation);
        for (auto& points : points_)
            if (points) points->add_furthest(rotation);
    }
    /// On the side where an object is grown most: it stays in the middle.
    [[nodiscard]] static Vec3d most_clearance(const CutOptions& cut) {
        const Box3d growth = grown({Vec3d{}, Vec3d{}}, cut.whole_clearance_mm());
        Vec3d most;
        for (int axis = 0; axis < 3; ++axis) most[axis] = std::max(growth.max[axis], -growth.min[axis]);
        return most;
    }

  private:
    [[nodiscard]] Box3d turned(std::size_t zone, const Placement& lies) const {
        Box3d box;
        if (points_[zone]) box = points_[zone]->turned(lies.rotation);
        if (zones_[zone].stands_for) box.include(placed_box(*zones_[zone].stands_for, lies));
        return box;
    }

    ExtremePoints body_;
    CutOptions cut_;
    const std::vector<ItemZone>& zones_;
    std::vector<std::optional<ExtremePoints>> points_;  ///< of each zone, where it has a surface
};

class CaseSearch {
  public:
    CaseSearch(const Mesh& mesh, const Design& design, std::uint64_t seed, const std::vector<ItemZone>& zones)
        : design_(design),
          lengths_(mesh, design.cut, zones),
          allowed_(allowed_turns(design.search, design.placement.rotation_deg)),
          numbers_(seed) {
        const Vec3d size = bounds(mesh).size();
        longest_ = std::sqrt(dot(size, size));
        // What the design has stands first: where it is as good as any it stays.
        take(turn_of(rotation_from_euler(design.placement.rotation_deg)));
        for (const Turn& turn : suggested_turns(mesh)) take(turn);
        for (std::uint64_t i = 0; i < kSpread; ++i) take(allowed_.spread(i, seed));
    }

    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

    /// The blocks that lengths need, without walls.
    [[nodiscard]] Vec3d blocks(Vec3d lengths) const {
        return fitted_blocks(grown({lengths * -0.5, lengths * 0.5}, design_.cut.whole_clearance_mm()),
                             design_.space.block_mm);
    }

    /// How long an object may be that so many blocks hold.
    [[nodiscard]] Vec3d room(Vec3d blocks) const {
        const Vec3d most = TurnedLengths::most_clearance(design_.cut);
        Vec3d room;
        for (int axis = 0; axis < 3; ++axis)
            room[axis] = blocks[axis] * design_.space.block_mm[axis] + 0.02 - 2 * most[axis];
        return room;
    }

    /// mm that lengths exceed a room, where they exceed it most; 0 or less where they do not.
    [[nodiscard]] static double excess(Vec3d lengths, Vec3d room) {
        return std::max({lengths.x - room.x, lengths.y - room.y, lengths.z - room.z});
    }

    /// The closest to a room that any rotation comes, from the most promising samples.
    Sample turned_into(Vec3d room, double& least) {
        std::vector<std::pair<double, std::size_t>> starts;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            starts.emplace_back(excess(samples_[i].lengths, room), i);
        const auto kept = starts.begin() + static_cast<std::ptrdiff_t>(std::min(kStarts, starts.size()));
        std::partial_sort(starts.begin(), kept, starts.end());
        Sample best = samples_[starts.front().second];
        least = std::numeric_limits<double>::infinity();
        for (auto start = starts.begin(); start != kept; ++start) {
            if (start->first > kHopelessShare * longest_) break;
            const Sample end = climbed(samples_[start->second], room);
            if (const double over = excess(end.lengths, room); over < least) {
                least = over;
                best = end;
            }
            if (least <= 0) break;
        }
        return best;
    }

    /// With the lengths that all vertices give.
    Sample measured(const Sample& sample) {
        const Rotation rotation = rotation_from_euler(euler_of(rotation_of(sample.turn)));
        lengths_.add_furthest(rotation);
        return {sample.turn, lengths_(rotation)};
    }

  private:
    void take(const Turn& turn) {
        if (allowed_.allows(turn)) samples_.push_back(exact(turn));
    }

    /// As the project will have it: with rounded angles.
    Sample exact(const Turn& turn) const {
        const Turn rounded = turn_of(rotation_from_euler(euler_of(rotation_of(turn))));
        return {rounded, lengths_(rotation_of(rounded))};
    }

    /// Ever smaller turns towards a room; vertices that turn out to be missing are added on the way.
    Sample climbed(Sample at, Vec3d room) {
        double step = 8;
        for (int round = 0; round < 6; ++round) {
            double over = excess(at.lengths, room);
            for (int i = 0; i < kTries && over > 0; ++i) {
                const Turn turn = allowed_.small(numbers_, step * numbers_.between(0.2, 1)) * at.turn;
                const Vec3d lengths = lengths_(rotation_of(turn));
                const double next = excess(lengths, room);
                if (next <= over) {
                    // Where steps succeed they may be longer again.
                    step = std::min(8.0, step * (next < over ? 1.6 : 1.0));
                    over = next;
                    at = {turn, lengths};
                } else {
                    step = std::max(1e-5, step * 0.93);
                }
            }
            // The points are never longer than the object: what they refuse need not be measured.
            if (over > 0) return at;
            at = measured(exact(at.turn));
            if (excess(at.lengths, room) <= 0) return at;
            step = 0.5;
        }
        return at;
    }

    const Design& design_;
    TurnedLengths lengths_;
    AllowedTurns allowed_;
    SeededNumbers numbers_;
    double longest_ = 0;
    std::vector<Sample> samples_;
};

/// What a case costs: less is better, the first number first.
using Cost = std::array<double, 2>;

Cost cost(Vec3d blocks, const Design& design) {
    const Vec3d block = design.space.block_mm;
    const double volume = blocks.x * blocks.y * blocks.z;
    if (design.search.case_goal == CaseGoal::volume) return {volume, 0};
    double cm3 = 1;
    for (int axis = 0; axis < 3; ++axis) cm3 *= std::ceil(blocks[axis] * block[axis] / 10 - 1e-9);
    return {std::ceil(2 * cm3 / design.search.billed_divisor - 1e-9) / 2, volume};
}

struct CaseCandidate {
    Vec3d blocks;  ///< without walls
    double excess;
    Cost price;
};

/// Every case that costs less than the best so far and that some sample nearly fits, nearest first.
std::vector<CaseCandidate> cheaper_cases(const CaseSearch& search, const Design& design, Vec3d walls,
                                         Cost best) {
    Vec3d least{1e9, 1e9, 1e9}, most{1, 1, 1};
    for (const Sample& sample : search.samples()) {
        const Vec3d blocks = search.blocks(sample.lengths);
        for (int axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], blocks[axis]);
            most[axis] = std::max(most[axis], blocks[axis]);
        }
    }
    // Samples lie some degrees from the narrowest rotation.
    for (int axis = 0; axis < 3; ++axis) least[axis] = std::max(1.0, std::floor(least[axis] * 0.9) - 1);
    // Where blocks are very small not every count is tried.
    Vec3d step;
    for (int axis = 0; axis < 3; ++axis)
        step[axis] = std::max(1.0, std::floor((most[axis] - least[axis]) / 24));
    std::vector<CaseCandidate> cases;
    for (double x = least.x; x <= most.x; x += step.x)
        for (double y = least.y; y <= most.y; y += step.y)
            for (double z = least.z; z <= most.z; z += step.z)
                if (const Cost price = cost(Vec3d{x, y, z} + walls, design); price < best)
                    cases.push_back({{x, y, z}, std::numeric_limits<double>::infinity(), price});
    for (CaseCandidate& candidate : cases) {
        const Vec3d room = search.room(candidate.blocks);
        for (const Sample& sample : search.samples())
            candidate.excess = std::min(candidate.excess, CaseSearch::excess(sample.lengths, room));
    }
    std::stable_sort(cases.begin(), cases.end(),
                     [](const CaseCandidate& a, const CaseCandidate& b) { return a.excess < b.excess; });
    if (cases.size() > kMostCases) cases.resize(kMostCases);
    return cases;
}

}  // namespace

Result<FittedCase> fit_case(const Mesh& mesh, const Design& design, std::uint64_t seed,
                            const Progress& progress, const std::vector<ItemZone>& zones) {
    CaseSearch search(mesh, design, seed, zones);
    const Vec3d walls = wall_blocks(design.space.wall_mm.value_or(equal_walls(50)), design.space.block_mm);

    Cost least{std::numeric_limits<double>::infinity(), 0};
    Sample best;
    const auto offer = [&](const Sample& sample) {
        const Cost price = cost(search.blocks(sample.lengths) + walls, design);
        if (!(price < least)) return;
        least = price;
        best = sample;
    };
    // Samples know some vertices only: each that seems better is looked at with all of them.
    for (const Sample& sample : search.samples())
        if (cost(search.blocks(sample.lengths) + walls, design) < least) offer(search.measured(sample));
    const std::vector<CaseCandidate> cases = cheaper_cases(search, design, walls, least);
    std::vector<Vec3d> refused;
    long long looked_at = std::ssize(search.samples());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!go_on(progress, static_cast<double>(i) / static_cast<double>(cases.size()))) break;
        ++looked_at;
        const Vec3d blocks = cases[i].blocks;
        if (!(cases[i].price < least)) continue;
        // What did not go into a larger case does not go into this one.
        const auto holds = [&blocks](Vec3d other) {
            return other.x >= blocks.x && other.y >= blocks.y && other.z >= blocks.z;
        };
        if (std::any_of(refused.begin(), refused.end(), holds)) continue;
        double excess = 0;
        const Sample end = search.turned_into(search.room(blocks), excess);
        if (excess > 0)
            refused.push_back(blocks);
        else
            offer(end);
    }
    const Vec3d counts = search.blocks(best.lengths) + walls;
    if (std::max({counts.x, counts.y, counts.z}) > kMostBlocks)
        return fail(ErrorKind::usage, say("space.too_many_blocks", {{"blocks", dimensions(counts, 0)}}));
    return FittedCase{euler_of(rotation_of(best.turn)), vec_cast<int>(counts), looked_at};
}

Result<Vec3d> fitting_rotation(const Mesh& mesh, const Design& design, const DesignSpace& space,
                               std::uint64_t seed, const std::vector<ItemZone>& zones) {
    CaseSearch search(mesh, design, seed, zones);
    const Vec3d inside =
        vec_cast<double>(space.blocks) - wall_blocks(wanted_wall_mm(design.space), space.block_mm);
    double excess = 0;
    if (std::min({inside.x, inside.y, inside.z}) > 0) {
        const Sample walled = search.turned_into(search.room(inside), excess);
        if (excess <= 0) return euler_of(rotation_of(walled.turn));
    }
    const Vec3d room = search.room(vec_cast<double>(space.blocks));
    Sample bare = search.turned_into(room, excess);
    if (excess <= 0) return euler_of(rotation_of(bare.turn));
    bare = search.measured(bare);
    std::vector<Message> too_long, one_axis;
    for (int axis = 0; axis < 3; ++axis)
        if (const double over = bare.lengths[axis] - room[axis]; over > 0)
            too_long.push_back(
                say(too_long.empty() ? "fit.too_long" : "fit.too_long_too",
                    {{"mm", number(std::max(over, 0.1), 1)}, {"axis", std::string(1, "xyz"[axis])}}));
    if (design.search.upright) one_axis.push_back(say("fit.one_axis_upright"));
    const Vec3d blocks = search.blocks(bare.lengths);
    return fail(ErrorKind::does_not_fit, say("fit.no_orientation", {{"space", dimensions(space.size())},
                                                                    {"too_long", too_long},
                                                                    {"one_axis", one_axis},
                                                                    {"blocks", dimensions(blocks, 0)}}));
}

}  // namespace snug
