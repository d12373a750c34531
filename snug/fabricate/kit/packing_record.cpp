#include "snug/fabricate/kit/packing_record.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr double kRow = 8.5;          // mm of a line to write on
constexpr double kLabelShare = 0.34;  // of the width
constexpr double kArrowsHeight = 14;  // mm
constexpr TextLook kLabel{kBodyText, kInk};
const Pen kRule{kHairline, 0.25, {}};

/// Two arrows over a line, as on cartons (ISO 780, "this way up").
void draw_this_way_up(PageBuilder& page, Vec2d corner) {
    constexpr double kHead = 5, kShaft = 1.6;
    std::vector<std::vector<Vec2d>> arrows;
    for (const double at : {3.5, 10.5}) {
        const double x = corner.x + at, top = corner.y, neck = top + kHead, foot = top + kArrowsHeight - 2.2;
        arrows.push_back({{x, top},
                          {x + kHead / 2, neck},
                          {x + kShaft / 2, neck},
                          {x + kShaft / 2, foot},
                          {x - kShaft / 2, foot},
                          {x - kShaft / 2, neck},
                          {x - kHead / 2, neck}});
    }
    page.loops(arrows, kInk);
    page.rectangle(corner + Vec2d{0, kArrowsHeight - 1.4}, {14, 1.4}, kInk);
}

/// A glass with a crack, likewise ("fragile").
void draw_fragile(PageBuilder& page, Vec2d corner) {
    // On a square of 100 x 100, the crack from the rim down into the bowl.
    const std::vector<Vec2d> glass{{22, 0},  {42, 0},  {37, 14}, {49, 25},  {42, 40},  {53, 24},
                                   {42, 13}, {50, 0},  {78, 0},  {78, 24},  {74, 40},  {66, 50},
                                   {55, 55}, {55, 84}, {74, 90}, {74, 100}, {26, 100}, {26, 90},
                                   {45, 84}, {45, 55}, {34, 50}, {26, 40},  {22, 24}};
    std::vector<Vec2d> loop;
    for (const Vec2d point : glass) loop.push_back(corner + point * (kArrowsHeight / 100));
    page.loops({std::move(loop)}, kInk);
}

void draw_ways(PageFlow& flow, const PackingRecord& record) {
    const std::array<Message, 4> rows{say("packing.record_count", {{"items", record.items}}),
                                      say("packing.record_condition"), say("packing.record_name"),
                                      say("packing.record_date")};
    const double width = flow.width(), label = kLabelShare * width, column = (width - label) / 2;
    const double height = kRow * static_cast<double>(rows.size() + 1);
    const Vec2d corner = flow.room(height + 2);
    PageBuilder& page = flow.page();
    for (int way = 0; way < 2; ++way)
        page.text(corner + Vec2d{label + way * column + 2, kRow - 2.4},
                  say(way == 0 ? "packing.record_in" : "packing.record_out"), {kBodyText, kInk, true});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = kRow * static_cast<double>(i + 1);
        page.line(corner + Vec2d{0, y}, corner + Vec2d{width, y}, kRule);
        page.text(corner + Vec2d{0, y + kRow - 2.4}, shortened(page.words(rows[i]), label - 2, kLabel),
                  kLabel);
    }
    page.line(corner + Vec2d{0, height}, corner + Vec2d{width, height}, kRule);
    for (int way = 0; way < 2; ++way) {
        const double x = label + way * column;
        page.line(corner + Vec2d{x, 0}, corner + Vec2d{x, height}, kRule);
    }
}

void draw_lines(PageFlow& flow, const PackingRecord& record) {
    const std::array<Message, 5> lines{
        say("packing.record_accession"),
        record.content_kg ? say("packing.record_gross_of", {{"kg", number(*record.content_kg, 3)}})
                          : say("packing.record_gross"),
        say("packing.record_parts"), say("packing.record_carrier"), say("packing.record_spare")};
    for (const Message& line : lines) {
        const Vec2d corner = flow.room(kRow);
        PageBuilder& page = flow.page();
        const std::string words = shortened(page.words(line), 0.62 * flow.width(), kLabel);
        page.text(corner + Vec2d{0, kRow - 2.4}, words, kLabel);
        page.line(corner + Vec2d{0.64 * flow.width(), kRow - 1.4}, corner + Vec2d{flow.width(), kRow - 1.4},
                  kRule);
    }
}

}  // namespace

void draw_packing_record(PageFlow& flow, const PackingRecord& record) {
    flow.heading(say("packing.record"));
    draw_ways(flow, record);
    draw_lines(flow, record);
    const Vec2d corner = flow.room(kArrowsHeight + 5);
    draw_this_way_up(flow.page(), corner + Vec2d{0, 3});
    double right = 18;  // mm
    if (record.fragile) {
        draw_fragile(flow.page(), corner + Vec2d{right, 3});
        right += kArrowsHeight + 4;
    }
    flow.page().text(corner + Vec2d{right, 3 + kArrowsHeight / 2 + 1.2}, say("packing.record_up"), kLabel);
}

}  // namespace snug
