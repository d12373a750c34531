#include "snug/check/find_relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "snug/base/text.h"
#include "snug/check/drop_sentence.h"
#include "snug/check/face_shocks.h"
#include "snug/check/item_lines.h"
#include "snug/check/pad_contacts.h"
#include "snug/check/relieved.h"
#include "snug/foam/item_cuts.h"

namespace snug {
namespace {

constexpr double kIslandStep = 10;  // mm
constexpr int kMostIslandSteps = 12;

struct TriedRelief {
    ReliefOptions options;
    std::size_t islands = 0;
    FaceShock floor;
};

/// An only item, tried on one relief after the other.
class ReliefTrials {
  public:
    ReliefTrials(const Packing& packing, const RelievedItem& item, const AxisLines& lines)
        : tried_(packing), item_(item), lines_(lines), curves_(*packing.protection->foam) {
        tried_.findings.clear();
    }

    /// What the drop on the floor then comes to; none where there are no such islands, or where they would
    /// bottom with little more.
    [[nodiscard]] std::optional<TriedRelief> on(const Packing& packing, const ReliefOptions& options) {
        BlockMap layer = packing.layers.front();
        FloorRelief relief = relief_islands(layer, item_, packing.space, options);
        if (relief.islands.empty()) return {};
        cut_relief(layer, item_, relief);
        const std::size_t islands = relief.islands.size();
        tried_.relief = std::move(relief);
        tried_.foams = split(std::span(&layer, 1), packing.foams->parting, packing.available);
        Protection all = *packing.protection;
        add_face_shocks(pad_contacts(lines_, tried_, {}), tried_, curves_, all);
        const ItemProtection& held = all.items.front();
        if (!held.relief || held.relief->bottoms || !held.faces[kFloor].g_high) return {};
        return TriedRelief{options, islands, held.faces[kFloor]};
    }

  private:
    Packing tried_;
    const RelievedItem& item_;
    const AxisLines& lines_;
    Curves curves_;
};

/// Islands nearly through the foam: two heights, and from the least width upwards.
std::vector<ReliefOptions> trials(const FloorRelief& asked_too_little, const DesignSpace& space,
                                  double rib_mm) {
    std::vector<ReliefOptions> all;
    const double block = space.block_mm.x, foam = asked_too_little.foam_mm;
    const int least = static_cast<int>(std::ceil(kLeastReliefShare * foam / block - 1e-9));
    const int most = static_cast<int>(std::round(foam / block)) - 1;
    for (const int blocks : {least, most}) {
        if (blocks < least || blocks > most) continue;
        const double height = blocks * block;
        const double narrowest = std::ceil(std::max(kBucklingShare * height, rib_mm) / 5) * 5;
        for (int i = 0; i < kMostIslandSteps; ++i) all.push_back({height, narrowest + i * kIslandStep});
    }
    return all;
}

bool is_better(const TriedRelief& a, const std::optional<TriedRelief>& b) {
    return !b || *a.floor.g_high < *b->floor.g_high;
}

}  // namespace

void find_relief(const Packing& packing, const Design& design, std::vector<Finding>& findings) {
    if (!packing.relief) return;
    const double height = packing.relief->blocks * packing.space.block_mm.x;
    const ReliefIsland& first = packing.relief->islands.front();
    const double wide = (first.end_k - first.first_k) * packing.space.block_mm.z;
    const double deep = (first.end_j - first.first_j) * packing.space.block_mm.y;
    findings.push_back({Severity::note,
                        say("relief", {{"islands", packing.relief->islands.size()},
                                       {"size", number(wide, 1) + " x " + number(deep, 1)},
                                       {"height_mm", number(height, 1)}}),
                        {},
                        {}});
    const auto& held = packing.protection ? packing.protection->items.front().relief : std::nullopt;
    if (held && held->bottoms) findings.push_back({Severity::danger, say("relief_bottoms"), {}, {}});
    if (!design.fit.creep_kpa)
        findings.push_back({Severity::note, say("relief_creep_unknown"), {}, {}});
    else if (held && held->rest_kpa && *held->rest_kpa > *design.fit.creep_kpa / 2)
        findings.push_back({Severity::warning,
                            say("relief_creep", {{"kpa", number(*held->rest_kpa, 2)},
                                                 {"most_kpa", number(*design.fit.creep_kpa / 2, 2)}}),
                            {},
                            {}});
    sort_by_severity(findings);
}

Result<std::optional<ReliefOffer>> offered_relief(std::span<const Object> objects, const Design& design,
                                                  const Packing& packing) {
    if (design.fit.relief || never_relieved(design) || !packing.protection || packing.foams->open())
        return std::nullopt;
    const ItemProtection& held = packing.protection->items.front();
    if (verdict_on(held.faces[kFloor], held) != DropVerdict::over) return std::nullopt;
    const auto cuts = cut_items(objects, packing.items, packing.space);
    if (!cuts) return tl::unexpected(cuts.error());
    const Object& object = objects[packing.items.front().object];
    const auto item = relieved_item(object, packing, design, cuts->cuts.front().lower);
    if (!item) return tl::unexpected(item.error());
    const auto lines = axis_lines(objects, packing.items, packing.space, 0);
    if (!lines) return tl::unexpected(lines.error());
    ReliefTrials tried(packing, *item, *lines);
    const FloorRelief depth = relief_islands(packing.layers.front(), *item, packing.space,
                                             {packing.space.block_mm.x, packing.space.size().y});
    std::optional<TriedRelief> best;
    for (const ReliefOptions& options : trials(depth, packing.space, design.fit.least_rib_mm))
        if (auto found = tried.on(packing, options); found && is_better(*found, best))
            best = std::move(found);
    constexpr double kWorthIt = 0.9;  // of what is met without it
    if (!best || *best->floor.g_high > kWorthIt * *held.faces[kFloor].g_high) return std::nullopt;
    const std::string flag =
        "--relief " + number(best->options.height_mm, 1) + "x" + number(best->options.island_mm, 1);
    const bool enough = is_enough(best->floor, held);
    const Message text =
        say(enough ? "relief_offer" : "relief_offer/over", {{"flag", flag},
                                                            {"islands", best->islands},
                                                            {"range", drop_range(best->floor)},
                                                            {"asked", number(held.asked_g.value_or(0), 0)}});
    return ReliefOffer{best->options, {Severity::note, text, {}, {}}};
}

}  // namespace snug
