#include "wasm/arrangements.h"

#include <utility>

#include "snug/design/project.h"
#include "snug/make.h"
#include "snug/search/fill_space.h"
#include "snug/search/other_arrangements.h"
#include "snug/space/place_items.h"

namespace snug::wasm {
namespace {

/// Of the whole work; the others come after it.
constexpr double kBestShare = 0.7;

ArrangeWatch watch_for(std::span<const Object> objects, const ArrangementListeners& listeners, double from,
                       double to) {
    const Progress told = progress_from(listeners.progress);
    return {[told, from, to](double share, std::optional<double>) {
                return go_on(told, from + (to - from) * share);
            },
            [better = listeners.better](const Design& design) {
                if (!better.isNull()) better(design_json(design));
            },
            [objects](const Design& tried) { return pack(objects, tried); }};
}

val plan_of(std::span<const Object> objects, const Design& design) {
    val plan = val::array();
    const auto items = place_items(objects, design);
    if (!items) return plan;
    for (const Item& item : *items) {
        val one = val::object();
        one.set("layer", item.layer);
        one.set("min", to_val(item.placement.bounds.min));
        one.set("max", to_val(item.placement.bounds.max));
        plan.call<void>("push", one);
    }
    return plan;
}

val arranged_val(std::span<const Object> objects, const ArrangedDesign& arranged) {
    const Design& design = arranged.design;
    const DesignSpace space =
        design.space.blocks ? DesignSpace{*design.space.blocks, design.space.block_mm} : DesignSpace{};
    val result = val::object();
    result.set("design", design_json(design));
    result.set("volume_mm3", arranged.arrangement.volume_mm3);
    const auto least = arranged.arrangement.lower_bound_mm3;
    result.set("lower_bound_mm3", least ? val(*least) : val::null());
    result.set("layers", layers_of(design));
    result.set("size_mm",
               design.case_options.inside_mm ? to_val(*design.case_options.inside_mm) : to_val(space.size()));
    result.set("plan", plan_of(objects, design));
    return result;
}

val choices_val(const val& choices) {
    val result = val::object();
    result.set("choices", choices);
    return result;
}

}  // namespace

val arrange(std::span<Object> objects, const Design& design, const ArrangementListeners& listeners) {
    ArrangedDesign best{design, {}};
    const long long work = usual_arranging_work(design);
    const auto found =
        snug::arrange(objects, best.design, true, work, watch_for(objects, listeners, 0, kBestShare));
    if (!found) return to_val(found.error());
    best.arrangement = *found;
    val choices = val::array();
    choices.call<void>("push", arranged_val(objects, best));
    const ArrangementListeners quiet{listeners.progress, val::null()};
    for (const ArrangedDesign& other :
         other_arrangements(objects, design, best.design, work / 2, watch_for(objects, quiet, kBestShare, 1)))
        choices.call<void>("push", arranged_val(objects, other));
    return choices_val(choices);
}

val fill(std::span<Object> objects, const Design& design, std::size_t item,
         const ArrangementListeners& listeners) {
    ArrangedDesign filled{design, {}};
    const auto found = fill_space(objects, filled.design, item, usual_arranging_work(design) / 4,
                                  watch_for(objects, listeners, 0, 1));
    if (!found) return to_val(found.error());
    filled.arrangement = *found;
    val choices = val::array();
    choices.call<void>("push", arranged_val(objects, filled));
    return choices_val(choices);
}

}  // namespace snug::wasm
