#include "snug/words/catalogue.h"

// Files, the system and what is served.

namespace snug {
namespace {

constexpr Wording kWordsOfFiles[] = {
    {"console.no_output", "standard output cannot be written", "標準出力に書き込めません。"},
    {"file.shrank", "the file became shorter while it was read", "読み込み中にファイルが短くなりました。"},
    {"file.not_regular", "only a regular file can be read in pieces",
     "分割して読めるのは通常のファイルだけです。"},
    {"file.is_folder", "this is a folder, not a file", "ファイルではなくフォルダーです。"},
    {"file.no_folder", "{file}: there is no folder {folder}", "{file}: フォルダー {folder} がありません。"},
    {"file.unwritable", "{file}: cannot be written ({reason})", "{file}: 書き込めません（{reason}）。"},
    {"server.not_served", "port {port} of {host} cannot be served",
     "{host} のポート {port} では配信できません。"},
    {"server.no_studio",
     "{folder}: the studio is not there; `make build` makes it, and --files names another folder",
     "{folder}: スタジオがありません。`make build` で作るか、--files で別のフォルダーを指定してください。"},
    {"server.no_port", "no port of {host} is free", "{host} に空いているポートがありません。"},
    {"server.port_taken", "port {port} of {host} is taken: choose another with --port",
     "{host} のポート {port} は使用中です。--port で別のポートを選んでください。"},
    {"file.none", "there is no such file", "ファイルがありません。"},
    {"file.unreadable", "cannot be read ({reason})", "読み込めません（{reason}）。"},
    {"file.no_memory",
     "there is not enough memory for this object: make it smaller, or let `snug make --stream` read it in "
     "pieces, as a binary STL or PLY",
     "この対象物にはメモリーが足りません。データを小さくするか、バイナリの STL か PLY にして `snug make "
     "--stream` で分割して読み込んでください。"},
    {"zip.not_packed", "cannot be packed ({why})", "zip にできません（{why}）。"},
    {"pdf.long_page",
     "a page of a PDF is 5080 mm long at most; choose a paper size that the drawing is tiled for",
     "PDF のページは最大 5080 mm です。図を分割できる用紙を選んでください。"},
    {"pdf.no_japanese",
     "the pages are in Japanese, and no font that has its letters was found: install one (on Debian `apt "
     "install fonts-ipafont-gothic`), or name a TrueType font with --font",
     "日本語のページに使うフォントが見つかりません。インストールする（Debian では `apt install "
     "fonts-ipafont-gothic`）か、--font で TrueType フォントを指定してください。"},
    {"pdf.no_true_type", "this is no TrueType font that can be put into a PDF",
     "PDF に埋め込める TrueType フォントではありません。"},
    {"letters_missing",
     "no font was found that has {letters}: question marks stand for these letters in the PDFs. Install a "
     "font that has them, or name a TrueType font with --font",
     "{letters} を含むフォントが見つからず、PDF では疑問符になっています。その文字を含むフォントをインストー"
     "ルするか、--font で TrueType フォントを指定してください。"},
    {"pdf.no_memory", "there is no memory for it", "メモリーが足りません。"},
    {"pdf.not_made", "cannot be made (libharu error {error})",
     "作成できません（libharu のエラー {error}）。"},
    {"system.no_permission", "Permission denied", "権限がありません"},
    {"system.not_permitted", "Operation not permitted", "許可されていない操作です"},
    {"system.nothing_there", "No such file or directory", "ファイルもフォルダーもありません"},
    {"system.is_folder", "Is a directory", "フォルダーです"},
    {"system.no_folder", "Not a directory", "フォルダーではありません"},
    {"system.is_there", "File exists", "すでにあります"},
    {"system.disk_full", "No space left on device", "空き容量がありません"},
    {"system.quota", "Disk quota exceeded", "割り当て容量を超えました"},
    {"system.read_only", "Read-only file system", "読み取り専用です"},
    {"system.file_too_large", "File too large", "ファイルが大きすぎます"},
    {"system.long_name", "File name too long", "名前が長すぎます"},
    {"system.device", "Input/output error", "入出力エラー"},
    {"system.many_files", "Too many open files", "開いているファイルが多すぎます"},
    {"system.memory", "Cannot allocate memory", "メモリーが足りません"},
    {"system.not_empty", "Directory not empty", "フォルダーが空ではありません"},
    {"system.busy", "Device or resource busy", "使用中です"},
    {"system.many_links", "Too many levels of symbolic links", "シンボリックリンクの段数が多すぎます"},
    {"system.cancelled", "Operation canceled", "中止されました"},
    {"system.other", "{reason}", "システムのエラー：{reason}"},
};

}  // namespace

std::span<const Wording> words_of_files() {
    return kWordsOfFiles;
}

}  // namespace snug
