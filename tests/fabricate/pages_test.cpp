#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/check/protection.h"
#include "snug/design/known_foams.h"
#include "snug/design/presets.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/drawing/page_builder.h"
#include "snug/drawing/text_lines.h"
#include "snug/fabricate/bricks/brick_list.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

// What stands on the pages of each way of working, in both languages.

namespace snug {
namespace {

/// A sample in the usual foam of a way of working, so that its pack says as much as can be.
WorkshopPack pack_in(Language language, Workshop work, const std::string& preset, const char* object_name) {
    Project project;
    project.objects.front().file.name = object_name;
    Design& design = project.design;
    apply(*find_preset(built_in_presets(), preset), design);
    design.space.blocks.reset();
    design.object.longest_mm = 150;
    WorkshopOptions& options = design.workshop;
    options.work = work;
    options.mass_kg = 1.25;
    options.price_per_litre = 12.5;
    options.currency = "JPY";
    options.print.bed_mm = {120, 120, 120};
    options.mill.flute_mm = 150;
    const auto object = prepare(*sample("vase"), design);
    apply(*find_foam(built_in_foams(), "ld33"), design);
    design.protection.rule = DropRule::ista_2a;
    design.protection.fragility = FragilityClass::museum;
    auto packing = pack(*object, design);
    packing->protection = *protection({&*object, 1}, *packing, design);
    auto made = workshop_pack({&*object, 1}, *packing, project, {{}, {}, language});
    EXPECT_TRUE(made) << text(made.error().message);
    return made ? std::move(*made) : WorkshopPack{};
}

std::vector<Workshop> ways() {
    std::vector<Workshop> all;
    for (const std::string_view name : names_of<Workshop>().subspan(1))
        all.push_back(*value_named<Workshop>(name));
    return all;
}

/// Large blocks, which bricks alone do not take.
const char* preset_for(Workshop way) {
    return way == Workshop::bricks ? "lego-brick" : "slit-15";
}

std::vector<TextItem> texts_of(const Drawing& page) {
    std::vector<TextItem> texts;
    for (const DrawingItem& item : page.items)
        if (const auto* text = std::get_if<TextItem>(&item.what)) texts.push_back(*text);
    return texts;
}

/// What a line of text covers of its baseline; of upright text a point.
struct Span {
    double left, right;
};
Span span_of(const TextItem& text) {
    const double width = text.turn_deg == 0 ? text_width(text.text, text.height_mm, text.bold) : 0;
    const double left = text.at.x - (text.anchor == TextAnchor::start    ? 0
                                     : text.anchor == TextAnchor::middle ? width / 2
                                                                         : width);
    return {left, left + width};
}

/// Words in Latin letters but for those that are written on foams and cutters' screens, units, names of files
/// and of what is sold, and sources, which are quoted.
std::vector<std::string> latin_words(std::string text) {
    static const std::regex kKept(
        R"([a-z-]+/[\w.-]+|[\w-]+\.(pdf|nc|3mf|csv|svg|dxf|mpd|xml|stl)|--[a-z-]+( (auto|plate|tiles))?|)"
        R"(`[^`]*`|\b(LOWER|LID|BACK|DXF|STL|LDraw|BrickLink|ISTA|ld33|Plastazote LD33 data sheet|customfoams.co.uk|JPY|mm|mm3|cm|cm3|kg|m|vase|step|lid|lower)\b|)"
        R"(\b[LU]\d+[a-z]*\b|\b(lower|lid|dowel)-\d+\b|\d+[a-z]\b)");
    std::replace(text.begin(), text.end(), '\n', ' ');
    text = std::regex_replace(text, kKept, " ");
    std::vector<std::string> words;
    static const std::regex kWord("[A-Za-z]{2,}");
    for (auto it = std::sregex_iterator(text.begin(), text.end(), kWord); it != std::sregex_iterator(); ++it)
        words.push_back(it->str());
    return words;
}

bool has_japanese(const std::string& text) {
    return std::any_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) >= 0xe3; });
}

TEST(Pages, SpeakOneLanguage) {
    for (const Workshop way : ways()) {
        SCOPED_TRACE(name_of(way));
        for (const Language language : {Language::english, Language::japanese}) {
            const bool japanese = language == Language::japanese;
            for (const DrawingDocument& document :
                 pack_in(language, way, preset_for(way), "vase.stl").documents) {
                std::string all = document.title + "\n";
                for (const Drawing& page : document.pages) {
                    EXPECT_EQ(page.language, language) << document.name;
                    all += page.title + "\n";
                    for (const TextItem& text : texts_of(page)) all += text.text + "\n";
                }
                EXPECT_EQ(has_japanese(all), japanese) << document.name;
                if (japanese) {
                    EXPECT_EQ(latin_words(all), std::vector<std::string>()) << document.name;
                }
            }
        }
    }
}

TEST(Pages, NoTextLeavesItsPageOrMeetsAnotherInJapanese) {
    for (const Workshop way : ways()) {
        SCOPED_TRACE(name_of(way));
        const WorkshopPack pack = pack_in(Language::japanese, way, preset_for(way), "青磁の花瓶.stl");
        for (const DrawingDocument& document : pack.documents)
            for (const Drawing& page : document.pages) {
                std::vector<TextItem> texts = texts_of(page);
                for (const TextItem& text : texts) {
                    EXPECT_GE(span_of(text).left, 0) << document.name << ": " << text.text;
                    EXPECT_LE(span_of(text).right, page.size_mm.x + 1e-9)
                        << document.name << ": " << text.text;
                    EXPECT_LE(text.at.y, page.size_mm.y) << document.name << ": " << text.text;
                }
                std::stable_sort(texts.begin(), texts.end(), [](const TextItem& a, const TextItem& b) {
                    return span_of(a).left < span_of(b).left;
                });
                for (std::size_t i = 0; i < texts.size(); ++i)
                    for (std::size_t k = i + 1; k < texts.size(); ++k) {
                        if (texts[i].turn_deg != 0 || std::fabs(texts[i].at.y - texts[k].at.y) > 0.5)
                            continue;
                        EXPECT_LE(span_of(texts[i]).right, span_of(texts[k]).left + 1e-9)
                            << document.name << ": " << texts[i].text << " | " << texts[k].text;
                    }
            }
    }
}

TEST(Pages, AskForAFontThatHasTheirLetters) {
    const auto page = [](Language language) {
        PageBuilder builder("page", {100, 100}, language);
        builder.text({10, 10}, say("mark.lower"));
        return drawing_svg(builder.finish());
    };
    const std::string english = page(Language::english), japanese = page(Language::japanese);
    EXPECT_NE(english.find("Helvetica, Arial, 'Liberation Sans', sans-serif\""), std::string::npos);
    EXPECT_NE(english.find(">LOWER<"), std::string::npos);
    EXPECT_NE(japanese.find("IPAGothic, sans-serif\""), std::string::npos);
    EXPECT_NE(japanese.find(">下（LOWER）<"), std::string::npos);
}

TEST(Pages, ColoursOfBricksAreCalledAsTheyAreChosen) {
    for (const BrickColor& color : brick_colors()) {
        EXPECT_EQ(text(color_name(color)), color.name);
        EXPECT_TRUE(has_japanese(text(color_name(color), Language::japanese))) << color.name;
    }
}

}  // namespace
}  // namespace snug
