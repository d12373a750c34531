#include "snug/words/catalogue.h"

// How the program is called.

namespace snug {
namespace {

constexpr Wording kWordsOfUsage[] = {
    {"usage.required", "{name} is required", "{name} が必要です。"},
    {"usage.no_command", "A subcommand is required", "コマンドを指定してください。"},
    {"usage.not_expected", "The following {count|argument was|arguments were} not expected: {names}",
     "使えない引数です：{names}"},
    {"usage.requires", "{name} requires {other}", "{name} には {other} も必要です。"},
    {"usage.excludes", "{name} excludes {other}", "{name} は {other} と一緒に使えません。"},
    {"usage.no_number", "Could not convert: {name} = {found}",
     "{name} の値を読み取れません（指定：{found}）。"},
    {"usage.no_value", "{name}: 1 required {takes} missing", "{name} には値（{takes}）が必要です。"},
    {"usage.flag_value", "{name} was given a disallowed flag override", "{name} に値は付けられません。"},
    {"usage.range", "{name}: takes {least} to {most}, not {found}",
     "{name} に指定できるのは {least}～{most} です（指定：{found}）。"},
    {"usage.other", "{problem}", "コマンドを読み取れません（{problem}）。"},
    {"usage.see_help", "Run with --help for more information.", "--help で説明を表示します。"},
    {"project.object_gone", "{file}: its object {object} is not there; name it with --object FILE",
     "{file}: 対象物 {object} がありません。--object FILE で指定してください。"},
    {"project.object_gone/several",
     "{file}: its object {object} is not there; name the folder that its objects lie in with --object FOLDER",
     "{file}: 対象物 {object} がありません。対象物のあるフォルダーを --object FOLDER で指定してください。"},
    {"usage.object", "--object goes with a project (*.snug.json)",
     "--object はプロジェクト（*.snug.json）と一緒に使います。"},
    {"usage.sample_name", "{file}: the name must end in .stl, .ply, .obj or .off",
     "{file}: 名前の終わりは .stl、.ply、.obj、.off のどれかにしてください。"},
    {"usage.unit_stated",
     "the file states its unit itself: leave --units out; --scale or --longest make it another size",
     "ファイルに単位の記載があります。--units を外してください。大きさは --scale か --longest で変えられま"
     "す。"},
};

}  // namespace

std::span<const Wording> words_of_usage() {
    return kWordsOfUsage;
}

}  // namespace snug
