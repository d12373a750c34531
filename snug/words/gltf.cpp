#include "snug/words/catalogue.h"

// glTF files.

namespace snug {
namespace {

constexpr Wording kWordsOfGltf[] = {
    {"gltf.sparse", "a sparse accessor replaces element {at} of {count}: it is damaged; export it again",
     "疎なアクセサーが {count} 要素のうち {at} 番目を置き換えています。壊れているので、もう一度書き出して"
     "ください。"},
    {"gltf.accessor_type", "its accessor {index} is of type {has} where {wanted} is wanted: export it again",
     "アクセサー {index} の型は {has} ですが、{wanted} が必要です。もう一度書き出してください。"},
    {"gltf.no_accessor", "it speaks of accessor {index}, which it does not have: export it again",
     "アクセサー {index} が使われていますが、ありません。もう一度書き出してください。"},
    {"gltf.accessor_too_long",
     "it claims {elements} {elements|element|elements} where its buffer view {view} has {bytes} "
     "{bytes|byte|bytes}: it is damaged; export it again",
     "{elements} 要素と書かれていますが、バッファービュー {view} は {bytes} バイトしかありません。壊れてい"
     "るので、もう一度書き出してください。"},
    {"gltf.component_type", "its numbers are of type {type}, which glTF 2 does not have: export it again",
     "数値の型 {type} は glTF 2 にありません。もう一度書き出してください。"},
    {"gltf.geometry_beside", "its geometry lies in another file ({uri}): save it as .glb, which holds all",
     "形状が別のファイル（{uri}）にあります。すべてを含む .glb で保存してください。"},
    {"gltf.geometry_far",
     "its geometry lies at {uri}, and Snug reads only what lies beside the file: save it as .glb, which "
     "holds all",
     "形状が {uri} にあります。Snug が読むのはファイルの隣にあるものだけです。すべてを含む .glb で保存して"
     "ください。"},
    {"gltf.buffer_nowhere",
     "its buffer {index} is neither in the file nor in one beside it: export it again, best as .glb",
     "バッファー {index} が、ファイルの中にも隣のファイルにもありません。もう一度、できれば .glb で書き出"
     "してください。"},
    {"gltf.damaged_text", "the data in its text are damaged: export it again, best as .glb",
     "テキスト内のデータが壊れています。もう一度、できれば .glb で書き出してください。"},
    {"gltf.no_buffer", "it speaks of buffer {index}, which it does not have: export it again",
     "バッファー {index} が使われていますが、ありません。もう一度書き出してください。"},
    {"gltf.short_buffer",
     "its buffer {index} has {bytes} {bytes|byte|bytes} where {wanted} are wanted: the file or one beside "
     "it is cut off; copy or export it again",
     "バッファー {index} は {bytes} バイトですが、{wanted} バイト必要です。ファイルか、隣のファイルが途中"
     "で切れています。もう一度コピーまたは書き出しをしてください。"},
    {"gltf.no_view", "it speaks of buffer view {index}, which it does not have: export it again",
     "バッファービュー {index} が使われていますが、ありません。もう一度書き出してください。"},
    {"gltf.repeats_parts", "it repeats its parts more often than its size allows: save it as STL or PLY",
     "同じデータの繰り返しが、ファイルの大きさに対して多すぎます。STL か PLY で保存してください。"},
    {"gltf.version",
     "this is version {version} of glTF and Snug reads version 2: save it with a newer program, or as STL "
     "or PLY",
     "glTF のバージョン {version} です。Snug が読むのはバージョン 2 です。新しいソフトで、または STL か "
     "PLY で保存してください。"},
    {"gltf.ends_early", "the file ends too early: copy or export it again",
     "ファイルが途中で終わっています。もう一度コピーまたは書き出しをしてください。"},
    {"gltf.no_scene", "there is no scene in it: export it again",
     "シーンがありません。もう一度書き出してください。"},
    {"gltf.binary_version", "this is version {version} of glTF and Snug reads version 2: save it anew",
     "glTF のバージョン {version} です。Snug が読むのはバージョン 2 です。保存し直してください。"},
    {"gltf.extension_list", "its list of required extensions is damaged: export it again",
     "必要な拡張の一覧が壊れています。もう一度書き出してください。"},
    {"gltf.no_triangles", "there are no triangles in it", "三角形がありません。"},
    {"gltf.most_left_out",
     "most of its triangles ({left_out} of {faces}) have corners that are no numbers: repair or export it "
     "again",
     "三角形の大半（{faces} 個中 {left_out} 個）の頂点が数値ではありません。修復するか、もう一度書き出して"
     "ください。"},
    {"gltf.too_many_points", "it has more points than Snug can number",
     "点が多すぎて、Snug では番号を付けられません。"},
    {"gltf.triangle_point", "a triangle names point {point} of {points}: it is damaged; export it again",
     "三角形が {points} 点のうち {point} 番の点を指定しています。壊れているので、もう一度書き出してくださ"
     "い。"},
    {"gltf.no_point", "it names a point that it does not have: export it again",
     "存在しない点が指定されています。もう一度書き出してください。"},
    {"gltf.no_joint", "a point hangs on a joint that its skin does not have: export it again",
     "スキンにない関節に結び付いた点があります。もう一度書き出してください。"},
    {"gltf.too_many_mixed",
     "its shapes are mixed from more parts than its size allows: save it as STL or PLY",
     "変形に混ぜる形が、ファイルの大きさに対して多すぎます。STL か PLY で保存してください。"},
    {"gltf.too_many_triangles",
     "its nodes repeat what it holds to more than {most} triangles: save it with fewer copies, or as STL "
     "or PLY",
     "ノードの繰り返しで三角形が {most} 個を超えます。複製を減らすか、STL か PLY で保存してください。"},
    {"gltf.no_list", "its \"{name}\" is no list of {numbers} numbers: export it again",
     "\"{name}\" が {numbers} 個の数値の並びではありません。もう一度書き出してください。"},
    {"gltf.no_whole_number", "its \"{name}\" is no whole number of 0 or more: export it again",
     "\"{name}\" が 0 以上の整数ではありません。もう一度書き出してください。"},
    {"gltf.long_json",
     "its JSON has more than {most} values: export it as .glb or PLY, which keep them outside of text",
     "JSON の値が {most} 個を超えています。値をテキストの外に持つ .glb か PLY で書き出してください。"},
    {"gltf.deep_json", "its JSON nests deeper than that of any scene: export it again",
     "JSON の入れ子が、シーンではあり得ないほど深くなっています。もう一度書き出してください。"},
    {"gltf.instances",
     "a node repeats its mesh at {places} places and turns it {turns} times: export it again",
     "メッシュを {places} か所に複製するノードの回転が {turns} 個です。もう一度書き出してください。"},
    {"gltf.node_moved_too", "its scene lists node {node}, which node {parent} moves as well: export it again",
     "シーンにあるノード {node} を、ノード {parent} も動かしています。もう一度書き出してください。"},
    {"gltf.no_first_scene", "it opens with scene {scene}, which it does not have: export it again",
     "最初に開くシーン {scene} がありません。もう一度書き出してください。"},
    {"gltf.node_in_two",
     "its node {node} lies within two others, {first} and {second}, that place it differently: export it "
     "again",
     "ノード {node} が、位置の異なる二つのノード {first} と {second} の中にあります。もう一度書き出してく"
     "ださい。"},
    {"gltf.node_in_itself", "its node {node} lies within itself: export it again",
     "ノード {node} が自分自身の中にあります。もう一度書き出してください。"},
    {"gltf.no_node", "it speaks of node {node}, which it does not have: export it again",
     "ノード {node} が使われていますが、ありません。もう一度書き出してください。"},
    {"gltf.short_morph", "a shape that it is mixed with has fewer points than itself: export it again",
     "変形に混ぜる形の点が、元の形より少なくなっています。もう一度書き出してください。"},
    {"gltf.few_joints", "it has fewer joints and weights than points: export it again",
     "関節と重みの数が点の数より少なくなっています。もう一度書き出してください。"},
    {"gltf.points_without_bytes",
     "it claims {points} points without any bytes for them: it is damaged; export it again",
     "点 {points} 個と書かれていますが、データがありません。壊れているので、もう一度書き出してください。"},
    {"gltf.no_mesh", "it speaks of mesh {mesh}, which it does not have: export it again",
     "メッシュ {mesh} が使われていますが、ありません。もう一度書き出してください。"},
    {"gltf.skin_matrices",
     "its skin {index} has {joints} joints and {matrices} matrices for them: export it again",
     "スキン {index} の関節は {joints} 個ですが、その行列は {matrices} 個です。もう一度書き出してください。"},
    {"gltf.no_skin", "it speaks of skin {index}, which it does not have: export it again",
     "スキン {index} が使われていますが、ありません。もう一度書き出してください。"},
    {"gltf.no_json", "it holds no scene that can be read: its JSON is cut off or damaged; export it again",
     "読めるシーンがありません。JSON が途中で切れているか、壊れています。もう一度書き出してください。"},
    {"gltf.unknown_extension",
     "it needs {extension}, which Snug does not know and which may change its shape: save it without that "
     "extension, or as STL or PLY",
     "Snug の知らない拡張 {extension} が必要とされ、形が変わるかもしれません。その拡張なしで、または STL "
     "か PLY で保存してください。"},
    {"gltf.geometry_no_file", "its geometry lies in {name}, which is no file",
     "形状が {name} にありますが、ファイルではありません。"},
    {"gltf.geometry_not_beside",
     "its geometry lies in {name}, which is not beside it: put it there, or save it as .glb, which holds "
     "all",
     "形状のファイル {name} が隣にありません。そこに置くか、すべてを含む .glb で保存してください。"},
    {"gltf.geometry_not_opened",
     "its geometry lies in {name}: open both files at once, or save it as .glb, which holds all",
     "形状が別のファイル {name} にあります。両方を同時に開くか、すべてを含む .glb で保存してください。"},
    {"gltf.geometry_at",
     "its geometry lies at \"{name}\", and Snug reads only what lies beside the file: save it as .glb, "
     "which holds all",
     "形状が \"{name}\" にあります。Snug が読むのはファイルの隣にあるものだけです。すべてを含む .glb で保存"
     "してください。"},
};

}  // namespace

std::span<const Wording> words_of_gltf() {
    return kWordsOfGltf;
}

}  // namespace snug
