#include "snug/fabricate/kit/item_labels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "snug/drawing/stroke_text.h"
#include "snug/drawing/text_lines.h"

namespace snug {
namespace {

constexpr std::array<double, 4> kLabelHeights{8, 6, 5, 4};   // mm, the first that fits
constexpr std::array<double, 5> kBeside{4, 12, 20, 30, 40};  // mm from the item, the first that has room
constexpr double kAroundLabel = 1.5;                         // mm of flat foam around it
constexpr int kPlacesTried = 24;                             // to either side along an item

bool can_be_engraved(std::string_view words) {
    return std::all_of(words.begin(), words.end(), [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code < 0x80 &&
               (std::isalnum(code) || std::string_view("-+./ ").find(c) != std::string_view::npos);
    });
}

struct Rectangle {
    Vec2d low, high;
};

Rectangle extent_of(const std::vector<std::vector<Vec2d>>& lines) {
    Rectangle box{{1e9, 1e9}, {-1e9, -1e9}};
    for (const auto& line : lines)
        for (const Vec2d p : line) {
            box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
            box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
        }
    return box;
}

/// However it is written.
Vec2d size_of(const ItemLabel& label, double height) {
    const Rectangle box = extent_of(stroke_text(label.strokes, {}, height));
    const Vec2d drawn = box.high - box.low;
    const Vec2d size{std::max(drawn.x, text_width(label.words, height, true)), std::max(drawn.y, height)};
    return size + Vec2d{2 * kAroundLabel, 2 * kAroundLabel};
}

/// Where labels may stand on the surface of one piece.
class FlatFoam {
  public:
    /// `away_mm`: that labels keep from what the layer cuts.
    FlatFoam(const BlockMap& layer, const Grid<Run>& below, int parting, const DesignSpace& space,
             double away_mm)
        : layer_(layer), below_(below), parting_(parting), space_(space), away_(away_mm) {}

    [[nodiscard]] bool holds(const Rectangle& label) const {
        const Vec3d size = space_.size();
        if (label.low.x < 0 || label.low.y < 0 || label.high.x > size.z || label.high.y > size.y)
            return false;
        const Vec2d away{away_, away_};
        if (!all_columns(label, [&](int j, int k) { return below_(j, k).end == parting_; }) ||
            !all_columns({label.low - away, label.high + away},
                         [&](int j, int k) { return layer_(j, k).none(); }))
            return false;
        return std::none_of(taken_.begin(), taken_.end(), [&](const Rectangle& other) {
            return label.low.x < other.high.x && other.low.x < label.high.x && label.low.y < other.high.y &&
                   other.low.y < label.high.y;
        });
    }
    void take(const Rectangle& label) { taken_.push_back(label); }
    /// The thinnest foam below a label, mm.
    [[nodiscard]] double foam_below(const Rectangle& label) const {
        int least = std::numeric_limits<int>::max();
        (void)all_columns(label, [&](int j, int k) {
            least = std::min<int>(least, below_(j, k).end - below_(j, k).first);
            return true;
        });
        return least * space_.block_mm.x;
    }

  private:
    template <class Holds>
    [[nodiscard]] bool all_columns(const Rectangle& met, Holds holds) const {
        const Vec3d block = space_.block_mm;
        const int last_j = std::min(layer_.ny(), static_cast<int>(std::ceil(met.high.y / block.y))),
                  last_k = std::min(layer_.nz(), static_cast<int>(std::ceil(met.high.x / block.z)));
        for (int j = std::max(0, static_cast<int>(met.low.y / block.y)); j < last_j; ++j)
            for (int k = std::max(0, static_cast<int>(met.low.x / block.z)); k < last_k; ++k)
                if (!holds(j, k)) return false;
        return true;
    }

    const BlockMap& layer_;
    const Grid<Run>& below_;
    int parting_;
    const DesignSpace& space_;
    double away_;
    std::vector<Rectangle> taken_;
};

/// Before it, behind it, to its right, to its left; at each side nearest to its middle.
std::optional<Rectangle> place_beside(const Rectangle& item, Vec2d size, const FlatFoam& foam) {
    const Vec2d middle = (item.low + item.high) * 0.5;
    for (const double away : kBeside)
        for (int off = 0; off <= kPlacesTried; ++off)
            for (const int way : {off, -off}) {
                const double front = item.high.y + away + size.y / 2, back = item.low.y - away - size.y / 2,
                             right = item.high.x + away + size.x / 2, left = item.low.x - away - size.x / 2,
                             x = middle.x + way * (item.high.x - item.low.x) / (2.0 * kPlacesTried),
                             y = middle.y + way * (item.high.y - item.low.y) / (2.0 * kPlacesTried);
                for (const Vec2d at : {Vec2d{x, front}, Vec2d{x, back}, Vec2d{right, y}, Vec2d{left, y}}) {
                    const Rectangle label{at - size * 0.5, at + size * 0.5};
                    if (foam.holds(label)) return label;
                }
            }
    return {};
}

Rectangle seen_from_above(const Box3d& box, const DesignSpace& space) {
    const Vec2d corner{space.face(2, 0), space.face(1, 0)};
    return {Vec2d{box.min.z, box.min.y} - corner, Vec2d{box.max.z, box.max.y} - corner};
}

}  // namespace

std::vector<std::vector<Vec2d>> label_lines(const ItemLabel& label) {
    auto lines = stroke_text(label.strokes, {}, label.height_mm);
    const Rectangle box = extent_of(lines);
    for (auto& line : lines)
        for (Vec2d& p : line) p = p + label.middle - (box.low + box.high) * 0.5;
    return lines;
}

ItemLabels item_labels(std::span<const Item> items, const std::vector<std::string>& names,
                       std::span<const BlockMap> layers, const Foams& foams, const DesignSpace& space,
                       double away_mm) {
    ItemLabels made;
    std::vector<FlatFoam> surfaces;
    for (std::size_t i = 0; i < layers.size(); ++i)
        surfaces.emplace_back(layers[i], foams.pieces[i], foams.parting[i], space, away_mm);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        ItemLabel label{items[i].layer, number + " " + names[i], number, {}, 0};
        const auto note = [&](const char* code) {
            made.findings.push_back({Severity::note, say(code, {{"name", names[i]}, {"number", number}})});
        };
        const bool engraved = can_be_engraved(names[i]);
        if (engraved) label.strokes = label.words;
        FlatFoam& foam = surfaces[static_cast<std::size_t>(label.layer) - 1];
        const Rectangle item = seen_from_above(items[i].placement.bounds, space);
        for (const double height : kLabelHeights) {
            const auto place = place_beside(item, size_of(label, height), foam);
            if (!place) continue;
            label.middle = (place->low + place->high) * 0.5;
            label.height_mm = height;
            label.foam_mm = foam.foam_below(*place);
            foam.take(*place);
            made.labels.push_back(label);
            break;
        }
        if (label.height_mm == 0)
            note("no_label");
        else if (!engraved)
            note("label_letters");
    }
    return made;
}

}  // namespace snug
