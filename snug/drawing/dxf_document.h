#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "snug/base/vec2.h"

namespace snug {

/// A layer of a DXF file: letters, digits, - and _ alone; one of the seven standard colours.
struct DxfLayer {
    std::string name;
    int color_number = 7;
};

/// A DXF file of AutoCAD 2000 (AC1015, the oldest version that states its unit) in the making: millimetres,
/// metric, everything in model space. Handles count up in the order of the calls.
class DxfDocument {
  public:
    /// All x and y of what follows lie within 0 and `size_mm`, y upward.
    DxfDocument(Vec2d size_mm, std::vector<DxfLayer> layers);

    void polyline(std::string_view layer, const std::vector<Vec2d>& points, bool closed);
    void circle(std::string_view layer, Vec2d centre, double radius);

    [[nodiscard]] std::string finish();

  private:
    Vec2d size_;
    std::vector<DxfLayer> layers_;
    unsigned next_handle_;
    std::string entities_;

    [[nodiscard]] std::string new_handle();
    void begin_entity(std::string_view type, std::string_view layer, std::string_view subclass);
};

}  // namespace snug
