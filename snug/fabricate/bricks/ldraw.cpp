#include "snug/fabricate/bricks/ldraw.h"

#include <algorithm>
#include <string_view>

#include "snug/base/one_line.h"

namespace snug {
namespace {

constexpr int kStud = 20, kPlate = 8;  // LDraw units
constexpr int kBetweenHalves = 4 * kStud;

std::string_view model_name(Half half) {
    return half == Half::lower ? "lower.ldr" : "lid.ldr";
}

std::string header(std::string_view name, const std::string& title) {
    const std::string file(name);
    return "0 FILE " + file + "\r\n0 " + title + "\r\n0 Name: " + file +
           "\r\n0 Author: Snug\r\n0 !LDRAW_ORG Unofficial_Model\r\n";
}

/// A part or model in its place; turned: its x axis points along -z.
std::string line(int color, int x, int y, int z, bool turned, std::string_view file) {
    const char* const matrix = turned ? " 0 0 1 0 1 0 -1 0 0 " : " 1 0 0 0 1 0 0 0 1 ";
    return "1 " + std::to_string(color) + " " + std::to_string(x) + " " + std::to_string(y) + " " +
           std::to_string(z) + matrix + std::string(file) + "\r\n";
}

/// Parts have their origin in the middle of the body's top and are long along x. Columns run along x, rows
/// along -z.
std::string brick_line(const Brick& brick, int color) {
    const BrickPart* part =
        brick_part(brick.kind, std::min(brick.rows, brick.columns), std::max(brick.rows, brick.columns));
    return line(color, kStud * brick.column + kStud / 2 * brick.columns, -kPlate * brick.top(),
                -kStud * brick.row - kStud / 2 * brick.rows, brick.rows > brick.columns,
                std::string(part->number) + ".dat");
}

}  // namespace

std::string ldraw_file(std::span<const ColoredBuild> halves, const std::string& object_name) {
    // Behind other words: LDraw takes FILE, STEP or !LDRAW_ORG at a line's beginning for an order.
    const std::string name = ": " + one_line(object_name);
    std::string text = header("foams.ldr", "Foams of bricks" + name);
    for (const ColoredBuild& half : halves) {
        if (half.build->bricks.empty()) continue;
        const bool lower = half.build->half == Half::lower;
        const int behind = lower ? 0 : kStud * half.build->rows + kBetweenHalves;
        text += line(half.color->ldraw, 0, 0, behind, false, model_name(half.build->half));
    }
    text += "0 STEP\r\n0 NOFILE\r\n";
    for (const ColoredBuild& half : halves) {
        if (half.build->bricks.empty()) continue;
        text += header(model_name(half.build->half),
                       (half.build->half == Half::lower ? "Lower half, cavity up" : "Lid, cavity up") + name);
        const Brick* before = nullptr;
        for (const Brick& brick : half.build->bricks) {
            if (before && (before->bottom != brick.bottom || before->kind != brick.kind))
                text += "0 STEP\r\n";
            text += brick_line(brick, half.color->ldraw);
            before = &brick;
        }
        text += "0 STEP\r\n0 NOFILE\r\n";
    }
    return text;
}

}  // namespace snug
