#include "snug/fabricate/kit/drop_pictures.h"

#include <utility>
#include <vector>

#include "snug/check/drop_sentence.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

constexpr double kBetweenFalls = 5;  // mm
constexpr double kFallHeight = 24;   // mm, without what is written beneath
constexpr double kFinestLine = 0.2;  // mm

void draw_shapes(PageBuilder& page, const std::vector<FallShape>& shapes, Vec2d corner) {
    for (FallShape shape : shapes) {
        for (Loop& loop : shape.loops)
            for (Vec2d& point : loop) point = point + corner;
        const auto pen =
            shape.stroke ? std::optional(Pen{*shape.stroke, shape.weight * kFinestLine, {}}) : std::nullopt;
        if (shape.closed)
            page.loops(std::move(shape.loops), shape.fill, pen);
        else
            page.lines(std::move(shape.loops), *pen);
    }
}

}  // namespace

void draw_drop_pictures(PageFlow& flow, std::span<const FallPicture> pictures, const Protection& protection) {
    const auto count = static_cast<double>(pictures.size());
    const Vec2d size{(flow.width() - (count - 1) * kBetweenFalls) / count, kFallHeight};
    const double scale = fall_scale(pictures, size);
    const bool several = !protection.items.front().name.empty();
    Vec2d corner = flow.room(kFallHeight + (several ? 19 : 15));
    for (const FallPicture& picture : pictures) {
        draw_shapes(flow.page(), fall_shapes(picture, scale, size), corner);
        const ItemProtection& item = protection.items[protection.worst_item(picture.face)];
        const FaceShock& face = item.faces[static_cast<std::size_t>(picture.face)];
        const Vec2d foot = corner + Vec2d{size.x / 2, size.y};
        flow.page().text(foot + Vec2d{0, 4}, fallen_on(picture.face),
                         {kSmallText, kSoftInk, false, TextAnchor::middle});
        flow.page().text(foot + Vec2d{0, 8.4}, drop_range(face),
                         {kBodyText, is_enough(face, item) ? kInk : kAlarm, true, TextAnchor::middle});
        if (face.travel_mm && face.g_high)
            flow.page().text(foot + Vec2d{0, 12.2}, drop_depth(face),
                             {kSmallText, kSoftInk, false, TextAnchor::middle});
        if (!item.name.empty())
            flow.page().text(foot + Vec2d{0, 16}, as_it_is(item.name),
                             {kSmallText, kSoftInk, false, TextAnchor::middle});
        corner.x += size.x + kBetweenFalls;
    }
}

}  // namespace snug
