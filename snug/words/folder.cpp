#include "snug/words/catalogue.h"

// The folder that a run writes into.

namespace snug {
namespace {

constexpr Wording kWordsOfFolder[] = {
    {"earlier_unknown",
     "the list of what earlier runs made in the folder ({list}) is damaged or of another version, so "
     "nothing of theirs was taken away: look for files that do not belong to this design",
     "以前の実行でフォルダーに作ったファイルの一覧（{list}）が壊れているか、別の版のものなので、以前のファ"
     "イルは取り除いていません。この設計に属さないファイルがないか確かめてください。"},
    {"earlier_files_stay/changed",
     "left in the folder, because they are not as they were written: {files}; do not use them with the "
     "files of this run",
     "書き出したときから変わっているため、フォルダーに残したファイル：{files}。今回のファイルと一緒に使わ"
     "ないでください。"},
    {"earlier_files_kept",
     "kept under the same name with .old behind it, because this run makes files of that name and no run "
     "wrote them as they were: {names}",
     "今回同じ名前のファイルを作りますが、以前の実行で書いたままのものではないため、名前の後に .old を付け"
     "て残しました：{names}"},
    {"earlier_files_stay/fixed",
     "left where they are, because their folder may not be written to: {files}; do not use them with the "
     "files of this run",
     "フォルダーに書き込めないため、そのまま残したファイル：{files}。今回のファイルと一緒に使わないでくだ"
     "さい。"},
    {"earlier_files_stay/read", "left in the folder, because this run read them: {files}",
     "今回の実行で読み込んだため、フォルダーに残したファイル：{files}"},
    {"earlier_unfinished",
     "an earlier run into the folder was stopped before it had finished; what it left is put right",
     "フォルダーへの以前の書き出しが途中で止まっていましたが、残ったものは整理しました。"},
    {"earlier_files", "taken away, because this run does not make them: {files}",
     "今回は作らないため取り除いたファイル：{files}"},
    {"of_earlier", "{count} {count|file|files} of an earlier run ({names})",
     "以前の実行のファイル {count} 件（{names}）"},
    {"names_and_more", "{names,}{more}", "{names,}{more}"},
    {"folder.busy", "{folder}: another run is still writing there; wait for it, or choose another folder",
     "{folder}: 別の実行が書き出し中です。終わるのを待つか、別のフォルダーを選んでください。"},
    {"folder.unreadable", "{folder}: cannot be read ({reason})", "{folder}: 読み込めません（{reason}）。"},
    {"folder.cannot_remove",
     "{file}: of an earlier run, cannot be taken away ({reason}); the folder holds a mix of two runs now, "
     "as {list} says",
     "{file}: 以前の実行のファイルですが、取り除けません（{reason}）。{list} にあるとおり、フォルダーには"
     "二回の実行のファイルが混ざっています。"},
    {"folder.cannot_keep",
     "{file}: no run of snug wrote this file as it is, and it cannot be kept under a second name: take it "
     "away, or choose another folder",
     "{file}: snug が書いたままのファイルではなく、別の名前で残すこともできません。取り除くか、別のフォル"
     "ダーを選んでください。"},
    {"folder.is_input",
     "{file}: this run reads the file and would write over it: choose another folder with --output",
     "{file}: 今回読み込むファイルに上書きしてしまいます。--output で別のフォルダーを選んでください。"},
    {"folder.name_taken",
     "{file}: this is not a file of snug's, which needs that name while it writes: take it away, or "
     "choose another folder",
     "{file}: snug のファイルではありませんが、snug は書き出し中にこの名前を使います。取り除くか、別のフォ"
     "ルダーを選んでください。"},
    {"folder.mixed", "{problem}; the folder holds a mix of two runs now, as {list} says",
     "{problem}{list} にあるとおり、フォルダーには二回の実行のファイルが混ざっています。"},
};

}  // namespace

std::span<const Wording> words_of_folder() {
    return kWordsOfFolder;
}

}  // namespace snug
