#include "snug/check/contact_map.h"

#include <algorithm>
#include <cstddef>

#include "snug/check/item_lines.h"
#include "snug/check/pad_contacts.h"
#include "snug/design/stress_curve.h"

namespace snug {
namespace {

/// What the report has of an item in a drop, or at rest.
struct Lies {
    NoShock why_none = NoShock::none;
    std::span<const ContactTravel> contacts;
};

Lies lies(const ItemProtection& item, std::optional<Side> side) {
    if (!side) return {item.rest.why_none, item.rest.contacts};
    const FaceShock& face = item.faces[static_cast<std::size_t>(*side)];
    return {face.why_none, face.contacts};
}

/// How near the ends of a column came; none where it does not belong to the item.
const ContactTravel* travel_of(std::span<const ContactTravel> contacts, const ContactColumn& column) {
    const auto found = std::find_if(contacts.begin(), contacts.end(), [&](const ContactTravel& each) {
        return each.low == column.low && each.high == column.high;
    });
    return found == contacts.end() ? nullptr : &*found;
}

std::vector<PressedColumn> pressed(std::span<const ContactColumn> columns, const Lies& item, int number,
                                   const StressCurve& curve) {
    std::vector<PressedColumn> all;
    for (const ContactColumn& column : columns) {
        const ContactTravel* const travel = travel_of(item.contacts, column);
        if (!travel) continue;
        const PadColumn& pad = column.pad;
        const double strain = (travel->near_mm - pad.gap_mm) / pad.thickness_mm;
        if (!(strain > 0)) continue;
        all.push_back({column.row, column.column, pad.u_mm, pad.v_mm, column.low == number, column.from_mm,
                       column.to_mm, pad.area_mm2, strain, curve.at(strain).kpa});
    }
    return all;
}

}  // namespace

Result<ContactMap> contact_map(std::span<const Object> objects, const Packing& packing, const Protection& all,
                               std::optional<Side> side, const Progress& progress) {
    ContactMap map;
    map.axis = side ? *side / 2 : 0;
    bool any = false;
    for (const ItemProtection& item : all.items) {
        map.items.push_back({lies(item, side).why_none, {}});
        any = any || map.items.back().why_none == NoShock::none;
    }
    if (!any) return map;
    const auto lines = axis_lines(objects, packing.items, packing.space, map.axis, progress);
    if (!lines) return tl::unexpected(lines.error());
    map.rows = lines->rows;
    map.columns = lines->columns;
    map.cell_mm = lines->cell_mm;
    const std::vector<ContactColumn> columns = contact_columns(*lines, packing, packing.pockets);
    const StressCurve curve(all.foam->curve);
    for (std::size_t i = 0; i < map.items.size(); ++i)
        if (map.items[i].why_none == NoShock::none)
            map.items[i].columns = pressed(columns, lies(all.items[i], side), static_cast<int>(i), curve);
    return map;
}

}  // namespace snug
