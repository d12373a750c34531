#pragma once

#include <optional>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/design/carrier.h"
#include "snug/design/cases.h"
#include "snug/design/design.h"
#include "snug/design/presets.h"
#include "snug/object/object.h"
#include "snug/search/shock_wishes.h"

namespace snug {

/// Which known cases may be chosen: cartons beside one that is made to measure, hard cases in its place.
enum class CaseChoice { cartons, hard_cases, none };
template <>
struct Names<CaseChoice> {
    static constexpr std::string_view list[] = {"cartons", "hard-cases", "none"};
};

/// Who carries it, and what may be used. The design says the rest: its foam's data, its case, its walls and
/// how it is turned hold where they are given.
struct PlanWishes {
    Carrier carrier = Carrier::parcel;
    std::vector<Workshop> ways{Workshop::sponge, Workshop::sheets};  ///< of working, that may be chosen
    bool own_blocks = false;  ///< the design's blocks are the foam that is there; else each way's usual ones
    std::vector<FoamMaterial> foams;  ///< whose data may be chosen, where the design names none
    std::vector<KnownCase> cases;     ///< that may be chosen
    bool in_known_case = false;  ///< one of them, where any holds the items, and none that is made to measure
    std::optional<double> seconds_each;  ///< of work for each piece; none: as work_time.h has it
};

/// Puts those of the known cases that are meant into the wishes. Parcel classes count as cartons where their
/// price is known: else there is nothing for which to fill them.
void choose_cases(const std::vector<KnownCase>& known, CaseChoice choice, PlanWishes& wishes);

/// Designs that are worth a look: for each way of working and foam the items laid as they take the least room
/// and settled onto their foam; with the walls that they need in a drop, where that can be reckoned, else the
/// usual ones; and the same with more of it, and in the smallest of the cases that hold it, of hard cases if
/// need be with less foam. What cannot be made so is left out. Fails with the first reason where nothing is
/// left, and `cancelled`.
[[nodiscard]] Result<std::vector<Design>> planned_designs(std::span<Object> objects, const Design& design,
                                                          const PlanWishes& wishes, const PackIt& pack_it,
                                                          const Progress& progress = {});

}  // namespace snug
