#include "snug/words/catalogue.h"

// Files of meshes and points.

namespace snug {
namespace {

constexpr Wording kWordsOfMeshes[] = {
    {"mesh.too_many_vertices", "there are more than 2^32 - 2 vertices", "頂点が 2^32 - 2 個を超えています。"},
    {"mesh.no_number", "a vertex needs three numbers, not {word}",
     "頂点には三つの数値が必要ですが、{word} となっています。"},
    {"stl.four_corners", "a facet has more than three vertices", "三つより多い頂点を持つ面があります。"},
    {"stl.foreign_word", "{word} does not belong into an STL file",
     "{word} は STL ファイルの語ではありません。"},
    {"stl.end", "{word} is nothing that ends in an STL file",
     "{word} は STL ファイルの終わりの語ではありません。"},
    {"cloud.cut_off",
     "the file is cut off: it promises {promised} points and has {points}; copy or export it again",
     "ファイルが途中で切れています。{promised} 点と書かれていますが、{points} 点しかありません。もう一度コ"
     "ピーまたは書き出しをしてください。"},
    {"cloud.too_short", "{place}the file is too short for {count} points",
     "{place}ファイルが短く、{count} 点が入りません。"},
    {"read.empty", "the file is empty", "ファイルが空です。"},
    {"obj.wrong_index",
     "{place}the face wants vertex {vertex}, but the file has {vertices} {vertices|vertex|vertices}",
     "{place}面が頂点 {vertex} を指定していますが、ファイルの頂点は {vertices} 個です。"},
    {"obj.few_before",
     "{place}the face wants vertex {index} of only {vertices} {vertices|vertex|vertices} before it",
     "{place}面が頂点 {index} を指定していますが、それより前の頂点は {vertices} 個です。"},
    {"obj.no_vertex", "{place}{word} is no vertex number; they count from 1",
     "{place}{word} は頂点の番号ではありません。番号は 1 からです。"},
    {"mesh.no_number_at", "{place}a vertex needs three numbers, not {word}",
     "{place}頂点には三つの数値が必要ですが、{word} となっています。"},
    {"obj.no_faces",
     "there are lines, curves or free-form surfaces but no faces: export the object as a mesh of triangles",
     "線、曲線、自由曲面だけで、面がありません。三角形のメッシュとして書き出してください。"},
    {"off.no_vertex", "{place}{word} is no vertex; they run from 0 to {last}",
     "{place}{word} は頂点の番号ではありません。番号は 0～{last} です。"},
    {"off.no_corners", "{place}{word} is no number of corners", "{place}{word} は頂点の数ではありません。"},
    {"off.few_faces", "the file is cut off: it says {faces} {faces|face|faces} but ends after {found}",
     "ファイルが途中で切れています。面 {faces} 個と書かれていますが、{found} 個で終わっています。"},
    {"off.few_vertices",
     "the file is cut off: it says {vertices} {vertices|vertex|vertices} but ends after {found}",
     "ファイルが途中で切れています。頂点 {vertices} 個と書かれていますが、{found} 個で終わっています。"},
    {"off.binary", "this is a binary OFF file: export it as text, or as PLY or STL",
     "バイナリの OFF ファイルです。テキスト、または PLY か STL で書き出してください。"},
    {"off.kind", "{place}{word} is no kind of OFF that Snug reads: export it as plain OFF, PLY or STL",
     "{place}{word} は Snug が読める OFF の種類ではありません。通常の OFF、PLY、STL で書き出してください。"},
    {"off.too_short", "the file says {count} {what} but is too short for them; copy or export it again",
     "{what} {count} 個と書かれていますが、ファイルが短すぎます。もう一度コピーまたは書き出しをしてくださ"
     "い。"},
    {"off.no_count", "{place}the number of {what} is missing or no number: {word}",
     "{place}{what}の数がないか、数値ではありません：{word}"},
    {"off.too_many", "{place}{count} {what} are more than can be read",
     "{place}{what} {count} 個は多すぎて読めません。"},
    {"stl.text", "this is text but no STL: it begins with {text}; download or export the object again",
     "{text} で始まるテキストで、STL ではありません。もう一度ダウンロードまたは書き出しをしてください。"},
    {"stl.too_short",
     "the file is cut off: a binary STL has at least 84 bytes, this one {bytes}; copy or export it again",
     "ファイルが途中で切れています。バイナリの STL は 84 バイト以上ですが、{bytes} バイトしかありません。"
     "もう一度コピーまたは書き出しをしてください。"},
    {"stl.cut_off",
     "the file is cut off: it says {triangles} {triangles|triangle|triangles} but holds {held}; copy or "
     "export it again",
     "ファイルが途中で切れています。三角形 {triangles} 個と書かれていますが、{held} 個しかありません。もう"
     "一度コピーまたは書き出しをしてください。"},
    {"mesh.no_triangles", "there are no triangles in this file", "このファイルに三角形がありません。"},
    {"read.pieces_formats",
     "only a binary STL or a binary PLY is read in pieces, and this is none: export it as one, or read it "
     "whole with --no-stream where there is memory for it",
     "分割して読めるのはバイナリの STL と PLY だけです。そのどちらかで書き出すか、メモリーが足りるなら "
     "--no-stream で全体を読んでください。"},
    {"cloud.too_many", "there are more than 2^32 - 2 points", "点が 2^32 - 2 個を超えています。"},
    {"cloud.no_points", "there are no points in this file", "このファイルに点がありません。"},
    {"mesh.cloud",
     "there are {points} {points|point|points} but no triangles: this is a point cloud; make a mesh of it "
     "first",
     "点が {points} 個ありますが、三角形がない点群です。先にメッシュにしてください。"},
    {"mesh.points_left_out",
     "{left_out} of {all} points have a coordinate that is not a number, or beyond 1e30: too little would "
     "be left; repair it or export it again",
     "{all} 点のうち {left_out} 点の座標が、数値でないか 1e30 を超えています。残りが少なすぎるため、修復す"
     "るか、もう一度書き出してください。"},
    {"mesh.faces_left_out",
     "{left_out} of {all} faces have fewer than three corners or a corner with a coordinate that is not a "
     "number, or beyond 1e30: too little would be left; repair it or export it again",
     "{all} 面のうち {left_out} 面は、頂点が三つに満たないか、頂点の座標が数値でないか 1e30 を超えています。"
     "残りが少なすぎるため、修復するか、もう一度書き出してください。"},
    {"cloud.decimal_commas",
     "{place}commas beside other marks between the numbers may be decimal commas: write the points with "
     "decimal points",
     "{place}数値の間に他の記号と混ざったコンマがあり、小数点かもしれません。小数点にはピリオドを使ってく"
     "ださい。"},
    {"cloud.too_few_numbers", "{place}a point needs three numbers x y z, and here are only {columns}",
     "{place}点には x y z の三つの数値が必要ですが、{columns} 個しかありません。"},
    {"cloud.no_number", "{place}a point needs three numbers x y z, not {word}",
     "{place}点には x y z の三つの数値が必要ですが、{word} となっています。"},
    {"off.vertices", "vertices", "頂点"},
    {"off.faces", "faces", "面"},
    {"stl.cut_off_in_facet", "the file is cut off within its last facet; copy or export it again",
     "ファイルが最後の面の途中で切れています。もう一度コピーまたは書き出しをしてください。"},
    {"shape.empty", "write what it is made of, such as `box 143x87x40 r5 + cylinder 63x60 at 0,0,50`",
     "何からできているかを書いてください。例：`box 143x87x40 r5 + cylinder 63x60 at 0,0,50`"},
    {"shape.many", "more than 100 parts: an object from measurements is made of fewer",
     "100 個を超えています。寸法から作る対象物は、もっと少ない形で書いてください。"},
    {"shape.kind", "part {number}: {word} is none of `box`, `cylinder`, `cone` and `ball`",
     "{number} 番目の形：{word} は `box`、`cylinder`、`cone`、`ball` のどれでもありません。"},
    {"shape.missing", "part {number} is missing behind the +", "{number} 番目の形が + の後にありません。"},
    {"shape.size", "part {number}: its size in mm is missing or not understood; write it as in `{form}`",
     "{number} 番目の形：大きさ（mm）がないか、読み取れません。`{form}` のように書いてください。"},
    {"shape.range", "part {number}: sizes run from 0.1 to 10,000 mm, not {value}",
     "{number} 番目の形：大きさは 0.1 ～ 10,000 mm です（{value} は不可）。"},
    {"shape.far", "part {number}: {value} is beyond {most}",
     "{number} 番目の形：{value} は {most} を超えています。"},
    {"shape.radius", "part {number}: a radius of {radius} mm does not fit; up to {most} mm does",
     "{number} 番目の形：半径 {radius} mm は合いません。{most} mm までです。"},
    {"shape.rest",
     "part {number}: {word} is not understood; behind its size may stand `at X,Y,Z`, `turn A,B,C`, for a box "
     "its "
     "radius as `r5`, for a cylinder or cone `along x`, and `+` before the next part",
     "{number} 番目の形：{word} が読み取れません。大きさの後には `at X,Y,Z`、`turn A,B,C`、箱なら半径を `r5` "
     "のよう"
     "に、円柱と円錐なら `along x` を書けます。次の形の前には `+` を置きます。"},
    {"read.understood",
     "Snug reads STL, OBJ, PLY, OFF, glTF, 3MF and points as PLY, XYZ or PTS: export it as one of these",
     "Snug が読めるのは STL、OBJ、PLY、OFF、glTF、3MF と、PLY、XYZ、PTS の点群です。そのどれかで書き出して"
     "ください。"},
    {"read.unknown", "this is no mesh that Snug knows; {understood}",
     "Snug の知らない形式です。{understood}"},
};

}  // namespace

std::span<const Wording> words_of_meshes() {
    return kWordsOfMeshes;
}

}  // namespace snug
