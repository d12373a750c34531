#include "snug/search/shock_pose.h"

#include <cstdint>
#include <span>

#include "snug/base/rotation.h"
#include "snug/base/seeded_numbers.h"
#include "snug/search/turn.h"

namespace snug {
namespace {

constexpr int kSpread = 64;         // poses
constexpr int kEighths = 8;         // of a turn about the upright axis
constexpr int kTurns = 24;          // small ones
constexpr double kWidestTurn = 12;  // degrees
constexpr double kNarrower = 0.9;   // each is than the one before it

class Poses {
  public:
    Poses(const Object& object, const Design& design, const PackIt& pack_it,
          const std::function<bool(double)>& news)
        : object_(object), tried_(design), pack_it_(pack_it), news_(news) {}

    /// From there on the best is known.
    Result<void> begin() {
        best_.rotation_deg = tried_.placement.rotation_deg;
        auto margin = margin_of(best_.rotation_deg);
        if (!margin) return tl::unexpected(margin.error());
        best_.margin = *margin;
        return {};
    }

    /// Whether it is better than all before. What cannot be packed so is not.
    bool look(const Turn& turn) {
        if (best_.cancelled) return false;
        constexpr double kAll = 6 * kEighths + kSpread + kTurns + 1;
        best_.cancelled = news_ && !news_(best_.looked_at / kAll);
        const Vec3d rotation_deg = euler_of(rotation_of(turn));
        const auto margin = margin_of(rotation_deg);
        if (!margin || *margin >= best_.margin) return false;
        best_.rotation_deg = rotation_deg;
        best_.margin = *margin;
        return true;
    }

    [[nodiscard]] const ShockPose& best() const { return best_; }

  private:
    Result<double> margin_of(Vec3d rotation_deg) {
        ++best_.looked_at;
        tried_.placement.rotation_deg = rotation_deg;
        const auto found = packed_shocks(std::span(&object_, 1), tried_, pack_it_);
        if (!found) return tl::unexpected(found.error());
        return worst_margin(found->protection);
    }

    const Object& object_;
    Design tried_;
    const PackIt& pack_it_;
    const std::function<bool(double)>& news_;
    ShockPose best_;
};

}  // namespace

Result<ShockPose> pose_of_least_shock(const Object& object, const Design& design, const PackIt& pack_it,
                                      const std::function<bool(double)>& news) {
    Poses poses(object, design, pack_it, news);
    if (auto done = poses.begin(); !done) return tl::unexpected(done.error());
    const Vec3d given_deg = design.placement.rotation_deg;
    const AllowedTurns allowed = allowed_turns(design.search, given_deg);
    if (allowed.only_one()) return poses.best();
    const Turn given = turn_of(rotation_from_euler(given_deg));
    for (const Turn& face : turns_onto_faces())
        for (int i = 0; i < kEighths; ++i) {
            const Turn turn = turn_about({1, 0, 0}, 360.0 / kEighths * i) * face * given;
            if (allowed.allows(turn)) (void)poses.look(turn);
        }
    const std::uint64_t seed = design.search.seed;
    for (int i = 0; i < kSpread; ++i) (void)poses.look(allowed.spread(static_cast<std::uint64_t>(i), seed));
    SeededNumbers numbers(seed);
    double widest = kWidestTurn;
    for (int i = 0; i < kTurns; ++i, widest *= kNarrower) {
        const Turn best = turn_of(rotation_from_euler(poses.best().rotation_deg));
        (void)poses.look(allowed.small(numbers, widest * numbers.between(0.3, 1)) * best);
    }
    return poses.best();
}

}  // namespace snug
