#include <gtest/gtest.h>

#include "snug/base/stopwatch.h"
#include "snug/design/presets.h"
#include "snug/drawing/text_lines.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/drawing_cells.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

struct Packed {
    Project project;
    Object object;
    Packing packing;
};

Packed packed(Mesh mesh, Workshop work) {
    Packed all;
    all.project.objects.front().file.name = "vase.stl";
    Design& design = all.project.design;
    apply(*find_preset(built_in_presets(), "slit-15"), design);
    design.space.blocks.reset();
    design.workshop.work = work;
    all.object = *prepare(std::move(mesh), design);
    all.packing = *pack(all.object, design);
    return all;
}

std::string words_of(const DrawingDocument& document) {
    std::string words;
    for (const Drawing& page : document.pages)
        for (const DrawingItem& item : page.items)
            if (const auto* text = std::get_if<TextItem>(&item.what)) words += text->text + " ";
    return words;
}

const DrawingDocument& packing_sheet_of(const WorkshopPack& pack) {
    return pack.documents.back();
}

TEST(WorkshopTest, FiguresFollowDensityAndPrice) {
    Packed vase = packed(*sample("vase"), Workshop::sponge);
    const auto dear = [&](std::optional<double> price, std::optional<double> density) {
        vase.project.design.workshop.price_per_litre = price;
        vase.project.design.workshop.density_kg_m3 = density;
        return workshop_pack({&vase.object, 1}, vase.packing, vase.project)->material;
    };
    EXPECT_FALSE(dear({}, {}).cost);
    EXPECT_NEAR(*dear(2.0, {}).cost, 2 * *dear({}, {}).litres, 1e-9);
    EXPECT_NEAR(*dear({}, {}).foam_kg, vase.packing.fit.foam_mm3 * 25e-9, 1e-9);
    EXPECT_NEAR(*dear({}, 50.0).foam_kg, vase.packing.fit.foam_mm3 * 50e-9, 1e-9);
    EXPECT_GE(*dear({}, {}).litres, vase.packing.fit.foam_mm3 * 1e-6);
}

TEST(WorkshopTest, ThePackingSheetNamesDangersFirstAndWhatNobodyChecked) {
    Packed vase = packed(*sample("vase"), Workshop::sponge);
    vase.packing.findings = {{Severity::danger, as_it_is("The foam would crush the neck.")},
                             {Severity::note, as_it_is("There are two parts.")}};
    vase.project.design.workshop.mass_kg = 1.25;
    const auto pack = workshop_pack({&vase.object, 1}, vase.packing, vase.project);
    ASSERT_TRUE(pack);
    const DrawingDocument& sheet = packing_sheet_of(*pack);
    EXPECT_EQ(sheet.name, "packing-sheet");
    EXPECT_LE(sheet.pages.size(), 2u);
    const std::string words = words_of(sheet);
    for (const char* word : {"vase", "1.25 kg", "DANGER", "crush the neck", "by hand", "BACK over BACK",
                             "floor 60", "litres", "Drops and shocks", "near collections"})
        EXPECT_NE(words.find(word), std::string::npos) << word;
    EXPECT_LT(words.find("DANGER"), words.find("two parts"));
}

TEST(WorkshopTest, NothingLeavesThePage) {
    Packed vase = packed(*sample("vase"), Workshop::sponge);
    vase.project.objects.front().file.name = std::string(300, 'W') + ".stl";
    for (const char* paper : {"a4", "letter", "a3"}) {
        vase.project.design.workshop.paper = paper;
        const auto pack = workshop_pack({&vase.object, 1}, vase.packing, vase.project);
        ASSERT_TRUE(pack) << snug::text(pack.error().message);
        for (const DrawingDocument& document : pack->documents)
            for (const Drawing& page : document.pages)
                for (const DrawingItem& item : page.items) {
                    if (const auto* text = std::get_if<TextItem>(&item.what)) {
                        const double width = text_width(text->text, text->height_mm, text->bold);
                        const double left = text->at.x - (text->anchor == TextAnchor::start    ? 0
                                                          : text->anchor == TextAnchor::middle ? width / 2
                                                                                               : width);
                        if (text->turn_deg != 0) continue;
                        EXPECT_GE(left, 0) << document.name << ": " << text->text;
                        EXPECT_LE(left + width, page.size_mm.x + 1e-9) << document.name << ": " << text->text;
                        EXPECT_LE(text->at.y, page.size_mm.y) << document.name << ": " << text->text;
                    }
                    if (document.true_size) continue;  // tiles are cut at the paper's edge
                    if (const auto* path = std::get_if<PathItem>(&item.what))
                        for (const auto& line : path->lines)
                            for (const Vec2d point : line) {
                                EXPECT_GE(std::min(point.x, point.y), 0) << document.name;
                                EXPECT_LE(point.x, page.size_mm.x) << document.name;
                                EXPECT_LE(point.y, page.size_mm.y) << document.name;
                            }
                }
    }
}

TEST(WorkshopTest, ASmallCavityLeavesNoRoomForFingersAndSaysSo) {
    Packed box = packed(test::box_mesh({0, 0, 0}, {60, 60, 60}), Workshop::sponge);
    const auto pack = workshop_pack({&box.object, 1}, box.packing, box.project);
    ASSERT_TRUE(pack);
    EXPECT_NE(words_of(packing_sheet_of(*pack)).find("ribbons"), std::string::npos);
}

TEST(WorkshopTest, TheFirstFileSaysWhichToOpenAndNamesAllOthers) {
    for (const Workshop work : {Workshop::sponge, Workshop::sheets, Workshop::print, Workshop::mould}) {
        Packed vase = packed(*sample("vase"), work);
        const auto pack = workshop_pack({&vase.object, 1}, vase.packing, vase.project);
        ASSERT_TRUE(pack);
        const PackFile& first = pack->files.front();
        EXPECT_EQ(first.name, "start-here.txt");
        const std::string told(reinterpret_cast<const char*>(first.bytes.data()), first.bytes.size());
        for (const DrawingDocument& document : pack->documents)
            EXPECT_NE(told.find(document.name + ".pdf: " + document.title + " (" +
                                std::to_string(document.pages.size()) + " page"),
                      std::string::npos)
                << told;
        for (const PackFile& file : std::span(pack->files).subspan(1))
            EXPECT_NE(told.find(file.name.substr(0, file.name.find('/'))), std::string::npos) << told;
        for (const PackContainer& container : pack->containers)
            EXPECT_NE(told.find(container.name.substr(0, container.name.find('/'))), std::string::npos)
                << told;
    }
}

TEST(WorkshopTest, WaysOfWorkingThatAreNotThereAreRefused) {
    Packed vase = packed(*sample("vase"), Workshop::none);
    EXPECT_EQ(workshop_pack({&vase.object, 1}, vase.packing, vase.project).error().kind, ErrorKind::usage);
    EXPECT_FALSE(value_named<Workshop>("felt"));
    EXPECT_EQ(any_of(names_of<Workshop>().subspan(1, 3)), "sponge, sheets or print");
}

TEST(WorkshopTest, OptionsSurviveTheProjectFile) {
    Project project;
    project.objects.front().file.name = "vase.stl";
    WorkshopOptions& workshop = project.design.workshop;
    workshop.work = Workshop::print;
    workshop.paper = "letter";
    workshop.price_per_litre = 12.5;
    workshop.currency = "EUR";
    workshop.mass_kg = 3.25;
    workshop.density_kg_m3 = 40.0;
    workshop.sponge.maps = MapSheets::plotter;
    workshop.sheets.thickness_mm = 7.5;
    workshop.sheets.stock_mm = {600, 300};
    workshop.sheets.kerf_mm = 0.15;
    workshop.sheets.dowels = 2;
    workshop.sheets.dxf = false;
    workshop.print.bed_mm = {180, 170, 160};
    workshop.print.dowels = false;
    workshop.print.dowel_length_mm = 30;
    const auto read = parse_project(project_json(project));
    ASSERT_TRUE(read) << snug::text(read.error().message);
    EXPECT_EQ(*read, project);
    std::string wrong = project_json(project);
    wrong.replace(wrong.find(": \"print\""), 9, ": \"knit\"");
    ASSERT_FALSE(parse_project(wrong));
    EXPECT_NE(snug::text(parse_project(wrong).error().message).find("workshop.for"), std::string::npos)
        << snug::text(parse_project(wrong).error().message);
}

TEST(WorkshopTest, ProjectsFromBeforeThereWerePacksAreRead) {
    const auto read = parse_project(R"({"snug": 1, "object": {"name": "vase.stl"}, "design": {}})");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->design.workshop, WorkshopOptions{});
}

TEST(TextLinesTest, AreAsFullAsTheyCanBeAndLoseNothing) {
    const std::string text =
        "Lower the object straight down into its cavity, without turning or pressing it.";
    const std::vector<std::string> lines = lines_of(text, 50, 3.5);
    std::string joined;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_LE(text_width(lines[i], 3.5), 50);
        if (i + 1 < lines.size()) {
            const std::string next = lines[i + 1].substr(0, lines[i + 1].find(' '));
            EXPECT_GT(text_width(lines[i] + " " + next, 3.5), 50);
        }
        joined += (i > 0 ? " " : "") + lines[i];
    }
    EXPECT_EQ(joined, text);
}

TEST(TextLinesTest, LongWordsAreBrokenBetweenCharacters) {
    std::string all;
    for (const std::string& line : lines_of("äöüäöüäöüäöü", 4, 3.5)) {
        EXPECT_LE(text_width(line, 3.5), 4);
        EXPECT_EQ(line.size() % 2, 0u) << "half a character";
        all += line;
    }
    EXPECT_EQ(all, "äöüäöüäöüäöü");
    EXPECT_EQ(lines_of("", 10, 3).size(), 1u);
    EXPECT_EQ(lines_of("WW", 0.1, 3).size(), 2u);
}

}  // namespace
}  // namespace snug
