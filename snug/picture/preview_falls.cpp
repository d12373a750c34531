#include "snug/picture/preview_falls.h"

#include "snug/check/drop_sentence.h"
#include "snug/picture/preview_marks.h"
#include "snug/picture/preview_style.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

constexpr Vec2d kFallSize{150, 130};  // px
constexpr double kFallGap = 34, kTitleHeight = 40, kFallCaption = 46;
constexpr double kFinestLine = 1;
constexpr Color kOver{178, 34, 34};

void draw_shapes(Canvas& canvas, const std::vector<FallShape>& shapes, Vec2d corner) {
    for (FallShape shape : shapes) {
        for (Loop& loop : shape.loops)
            for (Vec2d& point : loop) point = point + corner;
        const auto stroke =
            shape.stroke ? std::optional(Stroke{*shape.stroke, shape.weight * kFinestLine}) : std::nullopt;
        if (shape.closed)
            canvas.loops(shape.loops, shape.fill ? std::optional(Fill{*shape.fill}) : std::nullopt, stroke);
        else
            for (const Loop& line : shape.loops)
                for (std::size_t i = 1; i < line.size(); ++i) canvas.line(line[i - 1], line[i], *stroke);
    }
}

}  // namespace

double draw_falls(Canvas& canvas, std::span<const FallPicture> pictures, const PreviewFalls& falls,
                  double top, Language language) {
    canvas.layer("drops");
    const Lettering centred = anchored(kLegendText, TextAnchor::middle);
    Lettering range = centred;
    range.bold = true;
    canvas.text({kPageWidth / 2, top + 20}, 16, centred, falls.title);
    const double scale = fall_scale(pictures, kFallSize);
    const double width = static_cast<double>(pictures.size()) * (kFallSize.x + kFallGap) - kFallGap;
    Vec2d corner{(kPageWidth - width) / 2, top + kTitleHeight};
    for (const FallPicture& picture : pictures) {
        draw_shapes(canvas, fall_shapes(picture, scale, kFallSize), corner);
        const ItemProtection& item = falls.protection.items[falls.protection.worst_item(picture.face)];
        const FaceShock& face = item.faces[static_cast<std::size_t>(picture.face)];
        range.color = is_enough(face, item) ? kPreviewInk : kOver;
        const double middle = corner.x + kFallSize.x / 2, foot = corner.y + kFallSize.y;
        canvas.text({middle, foot + 20}, 14, centred, text(fallen_on(picture.face), language));
        canvas.text({middle, foot + 39}, 16, range, text(drop_range(face), language));
        corner.x += kFallSize.x + kFallGap;
    }
    return kTitleHeight + kFallSize.y + kFallCaption + 14;
}

}  // namespace snug
