#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/space/placement.h"

namespace snug {

/// A zone of an item, see zone_surface().
struct ItemZone {
    Zone asked;
    std::shared_ptr<const Object> surface;
    Box3d bounds;  ///< of the surface where it lies, or more; design coordinates
    /// Where the surface is that of a stand-in the box of what it stands for, in the object's coordinates:
    /// the bounds hold it, too.
    std::optional<Box3d> stands_for = {};

    /// How the foam gives way to it, of an item that it gives way to so: studs stand into the cavity here,
    /// too.
    [[nodiscard]] CutOptions own_cut(CutOptions of_item) const {
        of_item.clearance_mm = asked.keep_off_mm;
        of_item.liner_mm = 0;
        return of_item;
    }
    /// How far the foam stays away.
    [[nodiscard]] Clearance clearance_mm(const CutOptions& of_item) const {
        return own_cut(of_item).whole_clearance_mm();
    }
};

/// An object where it lies in the case: its own choices and, where it has none, the design's.
struct Item {
    std::size_t object = 0;  ///< which of the objects
    std::string name;        ///< its own or its object's, with its number where others are called the same
    std::string group;
    int layer = 1;  ///< the lowest is 1
    Vec3d rotation_deg;
    Vec3d offset_mm;  ///< as chosen or, for an item beside others, as it came out
    CutOptions cut;
    std::optional<double> mass_kg;
    Placement placement;
    std::vector<ItemZone> zones = {};
    double rise_mm = 0;     ///< in a tray, how far it was shifted along x beside its offset, see tray.h
    double settled_mm = 0;  ///< how far it was lowered onto its foam, see foam/settle.h
    std::optional<double> tip_deg = {};  ///< in a tray, how far it may be tilted, see tip_angle_deg()
};

/// Shifts it by so many mm.
void move(Item& item, Vec3d by);
/// The same along x in a tray: not an offset of its own.
void raise(Item& item, double mm);
/// The same downward onto foam.
void settle(Item& item, double mm);

/// What its zones keep free; empty where they keep nothing.
[[nodiscard]] Box3d kept_free_by_zones(const Item& item);
/// What an item takes up with its clearance and what its zones keep free; and what all of them take up
/// together.
[[nodiscard]] Box3d room_of(const Item& item);
[[nodiscard]] Box3d room_of(const std::vector<Item>& items);
/// Where pictures number an item, in design coordinates.
struct NumberedPlace {
    std::size_t number = 1;
    Vec3d at;
};
/// The middle of each item of a layer, numbered from 1 as all items are; empty where one lies there alone.
[[nodiscard]] std::vector<NumberedPlace> numbered_places(const std::vector<Item>& items, int layer = 1);
/// Their placed bounding boxes together.
[[nodiscard]] Box3d bounds_of(const std::vector<Item>& items);
/// Those of one layer, counted from 1.
[[nodiscard]] std::vector<Item> of_layer(const std::vector<Item>& items, int layer);

}  // namespace snug
