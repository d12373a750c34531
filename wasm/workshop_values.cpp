#include "wasm/workshop_values.h"

#include "snug/drawing/drawing_json.h"

namespace snug::wasm {
namespace {

template <class List, class ToValue>
val list_of(const List& list, ToValue to_value) {
    val result = val::array();
    for (const auto& one : list) result.call<void>("push", to_value(one));
    return result;
}

val or_null(const std::optional<double>& value) {
    return value ? val(*value) : val::null();
}

val ranked_val(const RankedCase& ranked, const Design& design) {
    const KnownCase& known = ranked.known;
    val result = val::object();
    result.set("name", known.name);
    result.set("kind", known.kind);
    result.set("maker", known.maker);
    result.set("inside_mm", to_val(known.inside_mm));
    result.set("lid_mm", or_null(known.lid_mm));
    result.set("divisor", known.has_flat_rate() ? val::null() : val(known.divisor.value_or(5000)));
    result.set("fill", ranked.fill);
    result.set("billed_kg", or_null(ranked.billed_kg));
    result.set("price", or_null(known.price));
    result.set("rotation_deg", to_val(rotation_for(ranked.lay, design.placement.rotation_deg)));
    result.set("lacking_mm", list_of(ranked.lacking_mm, [](double mm) { return val(mm); }));
    return result;
}

}  // namespace

val to_val(const WorkshopPack& pack) {
    val result = val::object();
    result.set("files", list_of(pack.files, [](const PackFile& file) { return to_val(file); }));
    result.set("documents", list_of(pack.documents, [](const DrawingDocument& document) {
                   val one = val::object();
                   one.set("name", document.name);
                   one.set("title", document.title);
                   one.set("trueSize", document.true_size);
                   one.set("pages", drawing_json(document));
                   return one;
               }));
    result.set("containers", list_of(pack.containers, [](const PackContainer& container) {
                   val one = val::object();
                   one.set("name", container.name);
                   one.set("members",
                           list_of(container.members, [](const PackFile& file) { return to_val(file); }));
                   return one;
               }));
    return result;
}

val figures_val(const WorkshopPack& pack) {
    val result = val::object();
    result.set("figures", list_of(pack.figures, [](const PackFigure& figure) {
                   val one = val::object();
                   one.set("label", to_val(figure.label));
                   one.set("value", to_val(figure.value));
                   return one;
               }));
    result.set("findings", to_val(pack.findings));
    return result;
}

val to_val(const CaseRanking& ranking, const Design& design) {
    val result = val::object();
    result.set("fitting", list_of(ranking.fitting,
                                  [&](const RankedCase& ranked) { return ranked_val(ranked, design); }));
    result.set("nearest", ranking.nearest ? ranked_val(*ranking.nearest, design) : val::null());
    result.set("leastInside", to_val(ranking.least_inside_mm));
    return result;
}

}  // namespace snug::wasm
