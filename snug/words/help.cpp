#include "snug/words/catalogue.h"

// What --help says; that of a design's options stands with them (snug/design).

namespace snug {
namespace {

constexpr Wording kWordsOfHelp[] = {
    {"help.default", "{help} ({usual})", "{help}（{usual}）"},
    {"help.set", "Any option by its name in a project file, after all others: {example}",
     "プロジェクトファイルでの名前による任意の設定。ほかのすべての指定の後に効きます：{example}"},
    {"help.snug",
     "Snug designs protective foam for an object that must travel: from a 3D model or a scan it\nmakes two "
     "foam halves in the blocks that real foam has.",
     "Snug は、運ぶ物を守る緩衝材を設計します。3D モデルやスキャンから、実際の緩衝材の\nブロックに合"
     "わせた二つの半分を作ります。"},
    {"help.example", "Example: {example}", "例：{example}"},
    {"help.examples", "Examples:{examples}", "例：{examples}"},
    {"help.every_command", "Every command has --help with an example.",
     "どのコマンドにも、例の付いた --help があります。"},
    {"help.help", "Print this help", "この説明を表示します"},
    {"help.version", "Display program version information and exit", "版を表示して終わります"},
    {"help.language", "Language of what is printed: en or ja (en)", "表示の言語：en または ja（en）"},
    {"help.commands", "Subcommands", "コマンド"},
    {"help.options", "Options", "オプション"},
    {"help.positionals", "Positionals", "引数"},
    {"help.usage", "Usage", "使い方"},
    {"help.required", "REQUIRED", "必須"},
    {"help.needs", "Needs", "必要"},
    {"help.excludes", "Excludes", "併用不可"},
    {"help.option_list", "OPTIONS", "オプション"},
    {"help.command", "SUBCOMMAND", "コマンド"},
    {"help.make", "Make foams from objects, or from a project file",
     "対象物（いくつでも）またはプロジェクトファイルから緩衝材を作ります"},
    {"help.make.object",
     "Meshes (STL, OBJ, PLY, OFF, glTF, 3MF) or point clouds (PLY, XYZ, PTS), each with choices of its own "
     "behind a colon if you like ({example}); or one project (*.snug.json)",
     "メッシュ（STL、OBJ、PLY、OFF、glTF、3MF）または点群（PLY、XYZ、PTS）。それぞれコロンの後に、そのものだ"
     "けの指定を付けられます（{example}）。またはプロジェクト（*.snug.json）一つ"},
    {"help.make.output",
     "The folder for the files that are made; what an earlier run made there and this one does not goes, "
     "unless somebody changed it",
     "作るファイルを入れるフォルダー。前回作って今回作らないファイルは、変更されていなければ取り除きます"},
    {"help.make.optimize", "Search the rotation and offset that are best; Ctrl-C keeps the best so far",
     "最も良い回転と位置を探します。Ctrl-C を押すと、それまでの最良を使います"},
    {"help.make.fit_case", "Choose the smallest block counts that hold the object and its walls (50)",
     "対象物と壁（50）が入る最少のブロック数を選びます"},
    {"help.make.arrange",
     "Arrange several items in the smallest space, or in the case or blocks that are given; by itself where "
     "some "
     "have no place (move=)",
     "複数のものを、最小の空間、または指定のケースやブロックの中に並べます。場所の決まっていないものがあれば"
     "、"
     "指定がなくても並べます"},
    {"help.make.no_arrange", "Let items without a place stand in a row", "場所のないものを一列に置きます"},
    {"help.make.known_case", "Arrange several items in the smallest of the known cases (`snug cases`)",
     "複数のものを、登録されたケース（`snug cases`）のうち最小のものに並べます"},
    {"help.make.seconds",
     "Search this long instead of a fixed amount of work; results then depend on the machine",
     "決まった量の代わりにこの秒数だけ探します。結果は計算機によって変わります"},
    {"help.make.no_stream", "Read even a large file whole", "大きなファイルも一度に読み込みます"},
    {"help.make.stream",
     "Read the object in pieces, so that it need not fit into memory (chosen by itself for large files)",
     "メモリーに入りきらない対象物を分割して読み込みます（大きなファイルでは自動）"},
    {"help.project_object", "The object's file, or the folder of several, for a project that lies elsewhere",
     "プロジェクトの隣にない場合の、対象物のファイル。複数なら、それらのあるフォルダー"},
    {"help.make.font", "A TrueType font for letters beyond Latin in the PDFs (one of this system)",
     "PDF の日本語などの文字に使う TrueType フォント（この計算機にあるもの）"},
    {"help.make.dry_run", "Say what would be made and what it takes; write nothing",
     "作るものと必要な材料だけを示し、何も書き出しません"},
    {"help.make.threads", "Threads to use at most; the files are the same for any number",
     "使うスレッドの最大数。いくつでもファイルは同じです"},
    {"help.make.quiet", "Print nothing but errors", "エラーのほかは表示しません"},
    {"help.make.json", "Print the report to standard output instead of the summary",
     "要約の代わりに報告を標準出力に書き出します"},
    {"help.inspect", "Tell size, holes, parts, volume and likely units",
     "大きさ、穴、部品、体積、ありそうな単位を示します"},
    {"help.inspect.object", "A mesh (STL, OBJ, PLY, OFF, glTF, 3MF) or a point cloud (PLY, XYZ, PTS)",
     "メッシュ（STL、OBJ、PLY、OFF、glTF、3MF）または点群（PLY、XYZ、PTS）"},
    {"help.inspect.json", "Print it as JSON", "JSON で書き出します"},
    {"help.sample", "Write an object that Snug generates, to try things with",
     "Snug が作る、試すための対象物を書き出します"},
    {"help.shape", "Write an object made of measured boxes, cylinders, cones and balls",
     "測った箱、円柱、円錐、球から対象物を作って書き出します"},
    {"help.shape.text",
     "Its parts in mm, joined by `+`: `box XxYxZ [rRADIUS]`, `cylinder DIAMETERxLENGTH`, `cone "
     "DIAMETERxTOPxLENGTH`, "
     "`ball DIAMETER`; behind each, where its middle stands (`at X,Y,Z`), how it is turned (`turn "
     "PSI,THETA,PHI`) and "
     "where an axis points (`along x`)",
     "mm での形を `+` でつなぎます：`box XxYxZ [rRADIUS]`（角の半径）、`cylinder "
     "DIAMETERxLENGTH`（直径と長さ）、"
     "`cone DIAMETERxTOPxLENGTH`（直径、先の直径、長さ）、`ball "
     "DIAMETER`（直径）。それぞれの後に、中心の位置（`at "
     "X,Y,Z`）、回転（`turn PSI,THETA,PHI`）、軸の向き（`along x`）を書けます"},
    {"help.shape.file",
     "The file; its ending says the format: .stl .ply .obj .off, or .shape, which `snug make` reads as well "
     "and which "
     "keeps the measurements",
     "ファイル。形式は名前の終わりで決まります：.stl .ply .obj .off、または寸法をそのまま残す .shape（`snug "
     "make` "
     "も読めます）"},
    {"help.sample.name", "{names/}", "見本の名前：{names/}"},
    {"help.sample.file", "The file; its ending says the format: .stl .ply .obj .off",
     "ファイル。形式は名前の終わりで決まります：.stl .ply .obj .off"},
    {"help.presets", "List the foams that Snug knows, and where to add your own",
     "Snug が知っている緩衝材と、自分の緩衝材を加える場所を示します"},
    {"help.cases", "List cartons and cases, or those that fit an object",
     "箱とケースを、または対象物が入るものを一覧します"},
    {"help.cases.for", "Only cases that fit this object (or project), best first",
     "この対象物（またはプロジェクト）が入るケースだけを、良い順に示します"},
    {"help.cases.mass", "The object's mass", "対象物の質量"},
    {"help.cases.wall", "Least foam on each side, as `snug make` takes it (50, or the project's)",
     "各面の緩衝材の最小の厚さ。`snug make` と同じ形です（50、またはプロジェクトの値）"},
    {"help.cases.preset", "The foam (paper, or the project's)",
     "緩衝材（`paper`、またはプロジェクトのもの）"},
    {"help.cases.clearance", "Grow the object by this (0, or the preset's)",
     "対象物をこれだけ大きくみなします（0、または緩衝材の値）"},
    {"help.cases.rotate", "How the object lies (0,0,0); its axes are exchanged too",
     "対象物の置き方（0,0,0）。軸の入れ替えも調べます"},
    {"help.cases.units", "The unit of the file (mm)", "ファイルの単位（mm）"},
    {"help.cases.play", "Air between foam and case on each side (3)", "緩衝材とケースの間の遊び、各面（3）"},
    {"help.cases.divisor", "cm3 for one kg of volumetric weight (5000)",
     "容積重量 1 kg あたりの cm3（5000）"},
    {"help.cases.json", "Print JSON instead of a table", "表の代わりに JSON を書き出します"},
    {"help.cases.csv", "Print the list as CSV, to extend", "一覧を、書き足せる CSV として書き出します"},
    {"help.studio", "Serve the studio to a browser on this machine",
     "この計算機のブラウザーでスタジオを使えるようにします"},
    {"help.studio.object", "A mesh or a project (*.snug.json) to open in it",
     "開くメッシュまたはプロジェクト（*.snug.json）"},
    {"help.studio.port", "Port of 127.0.0.1 (0: 8737, or the next free one)",
     "127.0.0.1 のポート（0：8737、または次に空いているもの）"},
    {"help.studio.files", "The built studio, if it is elsewhere", "別の場所にある場合の、作成済みのスタジオ"},
    {"help.studio.most_bytes", "Larger files are shown as a thinned copy (200,000,000)",
     "これより大きなファイルは間引いたコピーで表示します（200,000,000）"},
    {"help.studio.quiet", "Print the address and nothing else", "アドレスだけを表示します"},
    {"help.generate", "Print the manual page, or what a shell completes commands by",
     "マニュアルページ、またはシェルの補完定義を書き出します"},
    {"help.generate.kind", "What is printed: {words/}", "書き出すもの：{words/}"},
};

}  // namespace

std::span<const Wording> words_of_help() {
    return kWordsOfHelp;
}

}  // namespace snug
