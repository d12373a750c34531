#include "snug/design/cases.h"

#include <gtest/gtest.h>

#include "snug/search/rank_cases.h"
#include "snug/words/words.h"

#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

TEST(Cases, TheListIsReadBackAsItWasWritten) {
    const CaseList list = parse_cases(cases_csv(built_in_cases()));
    EXPECT_TRUE(list.problems.empty());
    ASSERT_EQ(list.cases.size(), built_in_cases().size());
    for (std::size_t i = 0; i < list.cases.size(); ++i) {
        EXPECT_EQ(list.cases[i].name, built_in_cases()[i].name);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(list.cases[i].inside_mm[axis], built_in_cases()[i].inside_mm[axis], 1e-6);
    }
    KnownCase odd;
    odd.name = "a \"b\", c";
    odd.kind = "# no comment";
    odd.inside_mm = {10, 20, 30};
    odd.price = 12.5;
    EXPECT_EQ(parse_cases(cases_csv({odd})).cases, std::vector<KnownCase>{odd});
}

TEST(Cases, ABadLineIsNamedAndTheOthersAreUsed) {
    const CaseList list = parse_cases(
        "name,length_mm,width_mm,height_mm,lid_mm\n"
        "# ours\n"
        "good,300,200,100,\n"
        "wide,200,300,100,30\r\n"
        "bad,300,two hundred,100,\n"
        "\n"
        ",300,200,100,\n"
        "lid,300,200,100,100\n"
        "open,\"300,200,100\n"
        "more,1,2,3,4,5\n"
        "few,300,200\n"
        "last,30,20,10");
    ASSERT_EQ(list.cases.size(), 3u);
    EXPECT_EQ(list.cases[1].inside_mm, (Vec3d{100, 200, 300}));
    EXPECT_EQ(list.cases[1].lid_mm, 30);
    EXPECT_EQ(list.cases[2].name, "last");
    ASSERT_EQ(list.problems.size(), 6u);
    EXPECT_EQ(text(list.problems[0]),
              "line 5: width_mm must be a number from 1 to 20000, not \"two hundred\"");
    EXPECT_EQ(text(list.problems[5]), "line 11: height_mm is missing");
}

TEST(Cases, ColumnsThatAreMissingOrUnknownAreNamed) {
    EXPECT_NE(text(parse_cases("name,length_mm,width_mm\n").problems.at(0)).find("height_mm"),
              std::string::npos);
    EXPECT_NE(text(parse_cases("name,length,width_mm,height_mm\n").problems.at(0)).find("\"length\""),
              std::string::npos);
}

TEST(Cases, AreFoundByMakerAndNameWhateverTheCapitals) {
    const auto named = [](std::string_view name) {
        const auto found = find_case(built_in_cases(), name);
        return found ? found->name : std::string();
    };
    for (const char* name : {"1450", "Peli 1450", "peli 1450", "Pelican Protector 1450"})
        EXPECT_EQ(named(name), "1450");
    EXPECT_EQ(named("Peli Storm im2100"), "iM2100");
    EXPECT_EQ(named("Nanuk 1450"), "");
    EXPECT_EQ(named("Peli1450"), "");
    std::vector<KnownCase> own = built_in_cases();
    own.push_back({});
    own.back().name = "PELI 1450";
    EXPECT_EQ(find_case(own, "PELI 1450")->name, "PELI 1450");
}

TEST(Cases, RandomTextIsReadOrRefused) {
    constexpr std::string_view kPieces[] = {"name", "length_mm", "width_mm", "height_mm", ",",   "\n",
                                            "\"",   "#",         "300",      "-1",        "nan", "1e9",
                                            "\r",   " ",         "\xff",     "price",     "box"};
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        std::string text = random.chance(0.7) ? "name,length_mm,width_mm,height_mm,price\n" : "";
        for (int i = random.integer(0, 60); i > 0; --i) text += kPieces[random.integer(0, 16)];
        const CaseList list = parse_cases(text);
        const CaseList again = parse_cases(cases_csv(list.cases));
        EXPECT_TRUE(again.problems.empty()) << snug::text(again.problems.front());
        EXPECT_EQ(again.cases, list.cases);
    }
}

Cargo cargo_of(Vec3d size) {
    return {size, {}, 5000};
}

TEST(RankCases, ThoseThatFitComeByFillThenBilledWeight) {
    Design design;
    design.space.wall_mm = equal_walls(25);
    const CaseRanking ranking = rank_cases(built_in_cases(), design, cargo_of({80, 100, 150}));
    ASSERT_GT(ranking.fitting.size(), 3u);
    for (std::size_t i = 1; i < ranking.fitting.size(); ++i) {
        const RankedCase &before = ranking.fitting[i - 1], &after = ranking.fitting[i];
        EXPECT_GE(before.fill, after.fill);
        if (before.fill == after.fill) {
            EXPECT_LE(before.billed_kg.value_or(1e9), after.billed_kg.value_or(1e9));
        }
    }
    for (const RankedCase& ranked : ranking.fitting)
        for (int axis = 0; axis < 3; ++axis) {
            const double size = Vec3d{80, 100, 150}[ranked.lay[static_cast<std::size_t>(axis)]];
            EXPECT_GE(ranked.known.inside_mm[axis], size + 50);
        }
}

TEST(RankCases, AFlatObjectIsLaidOnItsSideToFit) {
    KnownCase flat;
    flat.name = "flat";
    flat.inside_mm = {66, 306, 446};
    Design design;
    const CaseRanking ranking = rank_cases({flat}, design, cargo_of({400, 30, 200}));
    ASSERT_EQ(ranking.fitting.size(), 1u);
    EXPECT_EQ(ranking.fitting[0].lay, (Lay{1, 2, 0}));
}

TEST(RankCases, WhereNothingFitsTheNearestLacksLeast) {
    Design design;
    design.space.wall_mm = equal_walls(50);
    const CaseRanking ranking = rank_cases(built_in_cases(), design, cargo_of({900, 900, 900}));
    EXPECT_TRUE(ranking.fitting.empty());
    ASSERT_TRUE(ranking.nearest);
    EXPECT_EQ(ranking.nearest->known.name, "cube-24in");
    KnownCase enough;
    enough.name = "enough";
    enough.inside_mm = ranking.least_inside_mm;
    EXPECT_EQ(rank_cases({enough}, design, cargo_of({900, 900, 900})).fitting.size(), 1u);
    for (int axis = 0; axis < 3; ++axis) {
        KnownCase less = enough;
        less.inside_mm[axis] -= 0.1;
        EXPECT_TRUE(rank_cases({less}, design, cargo_of({900, 900, 900})).fitting.empty());
    }
}

TEST(RankCases, BilledWeightIsTheGreaterInWholeKilograms) {
    KnownCase known;
    known.inside_mm = {300, 400, 500};
    EXPECT_EQ(billed_kg(known, {{}, {}, 5000}), 12);
    EXPECT_EQ(billed_kg(known, {{}, 12.4, 5000}), 13);
    known.divisor = 6000;
    EXPECT_EQ(billed_kg(known, {{}, 1, 5000}), 10);
    known.kind = "parcel class";
    known.divisor.reset();
    EXPECT_EQ(billed_kg(known, {{}, {}, 5000}), std::nullopt);
    known.most_kg = 2;
    Design design;
    const CaseRanking ranking = rank_cases({known}, design, {{50, 50, 50}, 3, 5000});
    EXPECT_TRUE(ranking.fitting.empty());
    EXPECT_EQ(ranking.too_weak.size(), 1u);
}

}  // namespace
}  // namespace snug
