#include "snug/words/catalogue.h"

// zip archives, and the 3MF files in them.

namespace snug {
namespace {

constexpr Wording kWordsOfArchives[] = {
    {"bundle.member", "{name} in the zip archive: {problem}", "zip の中の {name}：{problem}"},
    {"bundle.geometry_elsewhere",
     "its geometry lies in {name}, which is not in the zip archive: pack both into one",
     "形状は {name} にありますが、zip の中にありません。両方を一つの zip にまとめてください。"},
    {"bundle.no_object",
     "there is no object in it: Snug looks for STL, OBJ, PLY, OFF, glTF, 3MF and points as PLY, XYZ or "
     "PTS, and neither in zips within it nor under names that lead out of it",
     "対象物が入っていません。Snug が探すのは STL、OBJ、PLY、OFF、glTF、3MF と、PLY、XYZ、PTS の点群です。"
     "zip の中の zip や、外を指す名前のファイルは探しません。"},
    {"bundle.no_object_of",
     "it holds foams and the project that they were made from, but not their object {name}: unpack it, "
     "and open the project with its object",
     "緩衝材と元のプロジェクトは入っていますが、その対象物 {name} がありません。展開して、プロジェクトを"
     "対象物と一緒に開いてください。"},
    {"threemf.extension",
     "it requires the extension \"{prefix}\"{address}, which Snug does not know, so its shape could be "
     "another than what is read: export it as STL, or as 3MF without that extension",
     "必要とされる拡張 \"{prefix}\"{address} を Snug は知らないため、読み取った形が違うかもしれません。STL、"
     "またはその拡張を使わない 3MF で書き出してください。"},
    {"threemf.unit", "its unit {unit} is none that 3MF knows", "単位 {unit} は 3MF にありません。"},
    {"threemf.transform", "the transform of object {object} is not twelve numbers",
     "オブジェクト {object} の変換が 12 個の数値ではありません。"},
    {"threemf.same_id", "there are two objects with the id {id}", "番号 {id} のオブジェクトが二つあります。"},
    {"threemf.no_whole_number", "the {attribute} of an element {name} is not a whole number",
     "要素 {name} の {attribute} が整数ではありません。"},
    {"threemf.no_model", "its first element is {name} and not the model of a 3MF",
     "最初の要素が {name} で、3MF の model ではありません。"},
    {"threemf.no_part", "{part} is not in it: export it again",
     "{part} が入っていません。もう一度書き出してください。"},
    {"threemf.most_left_out",
     "{left_out} of its {faces} triangles have corners that are not there or no numbers: repair or export "
     "it again",
     "三角形 {faces} 個のうち {left_out} 個の頂点が、存在しないか数値ではありません。修復するか、もう一度"
     "書き出してください。"},
    {"threemf.no_triangles", "there are no triangles in what it places",
     "配置されたものに三角形がありません。"},
    {"threemf.no_3mf", "this is no 3MF file: there is no 3D model in it",
     "3D モデルが入っていないため、3MF ファイルではありません。"},
    {"threemf.deep",
     "its components lie more than {most} deep within each other: export it as one mesh (STL or PLY)",
     "部品の入れ子が {most} 段を超えています。一つのメッシュ（STL か PLY）で書き出してください。"},
    {"threemf.unread", "{part} is {shape}, which Snug does not read: export it as a mesh, such as STL",
     "{part}は{shape}で、Snug では読めません。STL などのメッシュで書き出してください。"},
    {"threemf.not_there", "{part} is placed, but it is not there: export the file again",
     "{part}が配置されていますが、ありません。もう一度書き出してください。"},
    {"threemf.in_itself", "{part} is a component of itself: export it again",
     "{part}が自分自身の部品になっています。もう一度書き出してください。"},
    {"threemf.empty_build",
     "its build is empty, so it does not say which of its {objects} {objects|object|objects} are meant: "
     "place them in the program that wrote it, and export it again",
     "build が空で、{objects} 個のオブジェクトのどれを使うのかわかりません。作成したソフトで配置して、もう"
     "一度書き出してください。"},
    {"threemf.encrypted", "{part} is encrypted: export it again without encryption",
     "{part} は暗号化されています。暗号化せずに書き出してください。"},
    {"xml.wrong_end", "there is the end of an element {name}, where that of {wanted} is due",
     "{wanted} の終わりがあるべき所に、要素 {name} の終わりがあります。"},
    {"xml.end", "there is the end of an element {name}",
     "要素 {name} の終わりがありますが、始まりがありません。"},
    {"xml.namespaces", "more than {most} namespaces are declared",
     "{most} 個を超える名前空間が宣言されています。"},
    {"xml.attributes", "an element has more than {most} attributes",
     "一つの要素に {most} 個を超える属性があります。"},
    {"xml.quotes", "the attribute {name} has no quotes around its value, or no second one",
     "属性 {name} の値に引用符がないか、閉じていません。"},
    {"xml.tag", "the tag of {name} is damaged or cut off", "{name} のタグが壊れているか、途切れています。"},
    {"xml.deep", "its elements lie more than {most} deep within each other",
     "要素の入れ子が {most} 段を超えています。"},
    {"xml.no_name", "a tag has no name", "タグに名前がありません。"},
    {"xml.two_roots", "a second element follows the root", "ルート要素の後に二つ目の要素があります。"},
    {"xml.cut_off_comment", "it is cut off within a comment or a declaration",
     "コメントか宣言の中で途切れています。"},
    {"xml.cut_off", "it is cut off within the element {name}", "要素 {name} の中で途切れています。"},
    {"xml.nothing", "there is no element in it", "要素がありません。"},
    {"zip.shared_bytes",
     "members of the zip archive share bytes, as in archives that are made to fill a disk: pack it again",
     "ディスクを満杯にするための zip のように、中のファイルが同じデータを共有しています。圧縮し直してくだ"
     "さい。"},
    {"zip.beyond_end", "{name} goes beyond the end of the file", "{name} がファイルの終わりを超えている"},
    {"zip.not_there", "{name} is not where the directory says", "{name} が目次の位置にない"},
    {"zip.no_size", "the size of {name} is missing", "{name} の大きさがない"},
    {"zip.cut_entry", "an entry of its directory is cut off", "目次の項目が途切れている"},
    {"zip.no_entry", "its directory has an entry that is none", "目次に項目でないものがある"},
    {"zip.long_directory", "its directory is longer than the file", "目次がファイルより長い"},
    {"zip.several_parts", "the zip archive is one part of several: join them, or pack it again in one",
     "複数に分割された zip の一部です。結合するか、一つの zip にまとめ直してください。"},
    {"zip.no_directory", "the zip archive has no directory, so it is cut off: copy or download it again",
     "zip に目次がなく、途中で切れています。もう一度コピーまたはダウンロードしてください。"},
    {"zip.not_here", "{name} in the zip archive is packed, which cannot be unpacked here",
     "zip の中の {name} は圧縮されており、ここでは展開できません。"},
    {"zip.damaged_member", "{name} in the zip archive is damaged: copy or download it again",
     "zip の中の {name} が壊れています。もう一度コピーまたはダウンロードしてください。"},
    {"zip.too_large",
     "{name} in the zip archive unpacks to {size}; with what was unpacked before it is more than the "
     "{most} that Snug takes from an archive of this size (100 times its bytes, or 64 MiB): export it as "
     "STL or PLY",
     "zip の中の {name} を展開すると {size} になり、それまでの分と合わせて、この大きさの zip から Snug が"
     "取り出す上限 {most}（zip の 100 倍、または 64 MiB）を超えます。STL か PLY で書き出してください。"},
    {"zip.method",
     "{name} in the zip archive is packed by method {method}, which Snug does not read: pack it again "
     "with the usual one (DEFLATE)",
     "zip の中の {name} は方式 {method} で圧縮されており、Snug では読めません。通常の方式（DEFLATE）で圧縮"
     "し直してください。"},
    {"zip.encrypted", "{name} in the zip archive is encrypted: pack it again without a password",
     "zip の中の {name} は暗号化されています。パスワードなしで圧縮し直してください。"},
    {"threemf.boolean", "cut out of another by a boolean operation", "ブーリアン演算で切り抜かれた形"},
    {"threemf.level_set", "given by a function (a level set)", "関数（レベルセット）で表された形"},
    {"threemf.displaced", "a mesh that a picture displaces", "画像で凹凸を付けたメッシュ"},
    {"threemf.beam_lattice", "a beam lattice", "ビーム格子"},
    {"threemf.object_of", "object {object} of {part}", "{part} のオブジェクト {object} "},
    {"threemf.too_many_objects",
     "it has or repeats more than {most} objects: export it as one mesh (STL or PLY)",
     "オブジェクトが、繰り返しも含めて {most} 個を超えています。一つのメッシュ（STL か PLY）で書き出してく"
     "ださい。"},
    {"threemf.too_many_uses",
     "it has or repeats more than {most} items and components: export it as one mesh (STL or PLY)",
     "アイテムと部品が、繰り返しも含めて {most} 個を超えています。一つのメッシュ（STL か PLY）で書き出して"
     "ください。"},
    {"threemf.too_many_triangles",
     "it has or repeats more than {most} triangles: export it as one mesh (STL or PLY)",
     "三角形が、繰り返しも含めて {most} 個を超えています。一つのメッシュ（STL か "
     "PLY）で書き出してください。"},
    {"zip.damaged", "the zip archive is damaged ({what}): copy or download it again",
     "zip が壊れています（{what}）。もう一度コピーまたはダウンロードしてください。"},
    {"zip.no_memory", "there is no memory to unpack it", "展開するメモリーが足りません。"},
    {"zip.damaged_bytes", "what is packed in it is damaged", "圧縮された中身が壊れています。"},
};

}  // namespace

std::span<const Wording> words_of_archives() {
    return kWordsOfArchives;
}

}  // namespace snug
