#include "snug/words/catalogue.h"

// The manual page; what stands in the help as well is said there.

namespace snug {
namespace {

constexpr Wording kWordsOfManual[] = {
    {"manual.name", "NAME", "名前"},
    {"manual.what", "design protective foam from 3D models", "3D モデルから緩衝緩衝材を設計する"},
    {"manual.synopsis", "SYNOPSIS", "書式"},
    {"manual.command", "COMMAND", "コマンド"},
    {"manual.description", "DESCRIPTION", "説明"},
    {"manual.options", "OPTIONS", "オプション"},
    {"manual.commands", "COMMANDS", "コマンド"},
    {"manual.status", "EXIT STATUS", "終了ステータス"},
    {"manual.done", "Done", "正常に終わりました"},
    {"manual.wrong_usage", "Wrong usage", "使い方の誤り"},
    {"manual.bad_input", "Unreadable or implausible input", "入力を読めない、または妥当でない"},
    {"manual.does_not_fit", "The object does not fit", "対象物が入らない"},
    {"manual.cannot_write", "Output cannot be written", "出力を書き込めない"},
    {"manual.cancelled", "Cancelled", "中止された"},
};

}  // namespace

std::span<const Wording> words_of_manual() {
    return kWordsOfManual;
}

}  // namespace snug
