#include "snug/words/catalogue.h"

// What several topics say.

namespace snug {
namespace {

constexpr Wording kWordsOfGeneral[] = {
    {"in_both", "{english}", "{japanese}"},  // the one that has values of its own in each
    {"cancelled", "cancelled", "中止しました。"},
    {"drawing.small_paper", "the paper is too small for drawings at true size: take A4 or larger",
     "原寸の図には用紙が小さすぎます。A4 以上を選んでください。"},
    {"cancelled.nothing_written", "cancelled; nothing was written", "中止しました。何も書き出していません。"},
    {"sample.unknown", "there is no sample {name}; choose one of {known}",
     "見本 {name} はありません。次から選んでください：{known}"},
    {"workshop.none", "no pack was asked for: choose one of {names} with --for",
     "作り方が指定されていません。--for で次から選んでください：{names}"},
    {"at_line", "line {line}: ", "{line} 行目："},
    {"at_place", "{place}{problem}", "{place}{problem}"},
    {"at_part", "{part}, {problem}", "{part}、{problem}"},
    {"clp.no_solution", "the linear program has no solution that CLP could find",
     "CLP では線形計画の解が見つかりませんでした。"},
    {"in_file", "{file}: {problem}", "{file}: {problem}"},
};

}  // namespace

std::span<const Wording> words_of_general() {
    return kWordsOfGeneral;
}

}  // namespace snug
