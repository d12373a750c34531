#include "snug/words/catalogue.h"

// How the program is called.

namespace snug {
namespace {

constexpr Wording kRows[] = {
    {"project.object_gone", "{file}: its object {object} is not there; name it with --object FILE",
     "{file}: 対象物 {object} がありません。--object FILE で指定してください。"},
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
    return kRows;
}

}  // namespace snug
