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

/// Which known cases may be chosen, beside one that is made to measure.
enum class CaseChoice { cartons, hard_cases, none };
template <>
struct Names<CaseChoice> {
    static constexpr std::string_view list[] = {"cartons", "hard-cases", "none"};
};
/// Parcel classes count as cartons.
[[nodiscard]] std::vector<KnownCase> cases_to_choose(std::vector<KnownCase> known, CaseChoice choice);

/// Who carries it, and what may be used. The design says the rest: its foam's data, its case, its walls and
/// how it is turned hold where they are given.
struct PlanWishes {
    Carrier carrier = Carrier::parcel;
    std::vector<Workshop> ways{Workshop::sponge, Workshop::sheets};  ///< of working, that may be chosen
    bool own_blocks = false;  ///< the design's blocks are the foam that is there; else each way's usual ones
    std::vector<FoamMaterial> foams;     ///< whose data may be chosen, where the design names none
    std::vector<KnownCase> cases;        ///< that may be chosen, beside one that is made to measure
    std::optional<double> seconds_each;  ///< of work for each piece; none: as work_time.h has it
};

/// A design that is worth a look.
struct PlannedDesign {
    Design design;
    bool protects = false;  ///< its walls were chosen for what the items bear
    bool more = false;      ///< half as much foam again as is needed, for the sake of margin
};

/// For each way of working and foam the items laid as they take the least room and settled onto their foam;
/// with the walls that they need in a drop, where that can be reckoned, else the usual ones; and the same
/// with more of it, and in the smallest of the cases that hold it. What cannot be made so is left out. Fails
/// with the first reason where nothing is left, and `cancelled`.
[[nodiscard]] Result<std::vector<PlannedDesign>> planned_designs(std::span<Object> objects,
                                                                 const Design& design,
                                                                 const PlanWishes& wishes,
                                                                 const PackIt& pack_it,
                                                                 const Progress& progress = {});

}  // namespace snug
