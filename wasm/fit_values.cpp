#include "wasm/fit_values.h"

#include "snug/fabricate/kit/pad_pages.h"

namespace snug::wasm {

val box_val(const Box3d& box) {
    val result = val::object();
    result.set("min", to_val(box.min));
    result.set("max", to_val(box.max));
    return result;
}

val pads_val(const Packing& packing) {
    val list = val::array();
    for (const FillPad& pad : packing.pads.pads) {
        val one = val::object();
        one.set("item", pad.item);
        one.set("piece", pad.piece.index);
        one.set("above", pad.above);
        one.set("box", box_val(pad.box));
        one.set("text", to_val(pad_text(pad, packing.space)));
        list.call<void>("push", one);
    }
    return list;
}

val relief_val(const std::optional<ReliefOffer>& offer, const Packing& packing) {
    if (!offer) return val::null();
    val result = val::object();
    result.set("height_mm", offer->options.height_mm);
    result.set("island_mm", offer->options.island_mm);
    result.set("finding", to_val(std::vector{offer->finding}, packing.items)[0]);
    return result;
}

}  // namespace snug::wasm
