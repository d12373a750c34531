#include "snug/words/catalogue.h"

// PLY files.

namespace snug {
namespace {

constexpr Wording kWordsOfPly[] = {
    {"ply.wrong_index",
     "{noun} {number} wants vertex {vertex}, but there are {vertices} {vertices|vertex|vertices}, counted "
     "from 0",
     "{noun} {number} が頂点 {vertex} を指定していますが、頂点は {vertices} 個（0 から）です。"},
    {"ply.too_short",
     "the file is cut off: it says {count} of {name} but has room for {most} at most; copy or export it "
     "again",
     "ファイルが途中で切れています。{name} が {count} 個と書かれていますが、多くても {most} 個分の長さしか"
     "ありません。もう一度コピーまたは書き出しをしてください。"},
    {"ply.no_end", "the PLY header has no end (\"end_header\"): the file is cut off or damaged",
     "PLY のヘッダーに終わり（\"end_header\"）がありません。ファイルが途中で切れているか、壊れています。"},
    {"ply.no_property_name", "a property has no name", "property に名前がありません。"},
    {"ply.type", "{word} is no PLY type", "{word} は PLY の型ではありません。"},
    {"ply.list_type", "{word} is no type for a list's length", "{word} はリストの長さの型ではありません。"},
    {"ply.property_first", "a property stands before any element", "要素より前に property があります。"},
    {"ply.count", "{word} is no number of elements", "{word} は要素の数ではありません。"},
    {"ply.format", "{name} is no PLY format", "{name} は PLY の形式ではありません。"},
    {"ply.no_format", "the PLY header has no line \"format\"",
     "PLY のヘッダーに \"format\" の行がありません。"},
    {"ply.no_ply", "{place}{word} is no PLY file", "{place}{word} で始まる PLY ファイルはありません。"},
    {"ply.pieces_face",
     "face {number} has {corners} corners: only triangles are read in pieces; export the mesh with "
     "triangles, or read it whole with --no-stream",
     "面 {number} の頂点が {corners} 個あります。分割して読めるのは三角形だけです。三角形で書き出すか、"
     "--no-stream で全体を読んでください。"},
    {"ply.pieces_cloud",
     "there are no triangles in this file; a point cloud is not read in pieces: read it whole with "
     "--no-stream, thinned before where memory does not hold it",
     "このファイルに三角形がありません。点群は分割しては読めません。--no-stream で全体を、メモリーが足りな"
     "ければ先に間引いてから読んでください。"},
    {"ply.no_vertices", "the PLY has no element \"vertex\" with x, y and z",
     "この PLY に、x、y、z を持つ要素 \"vertex\" がありません。"},
    {"ply.pieces_twice",
     "the element {name} of this PLY is not the only one of its kind, so it is not read in pieces: join "
     "them, or read the file whole with --no-stream",
     "この PLY には同じ種類の要素 {name} が複数あるため、分割しては読めません。一つにまとめるか、"
     "--no-stream で全体を読んでください。"},
    {"ply.pieces_too_short",
     "the file is too short for {count} of {name}: it is cut off, or has faces with other than three "
     "corners",
     "ファイルが短く、{name} {count} 個が入りません。途中で切れているか、三角形でない面があります。"},
    {"ply.pieces_lists",
     "the element {name} of this PLY has lists, so it is not read in pieces: leave them out",
     "この PLY の要素 {name} にリストがあるため、分割しては読めません。リストを除いてください。"},
    {"ply.pieces_strips", "triangle strips are not read in pieces: export the PLY with plain faces",
     "三角形ストリップは、分割しては読めません。通常の面で PLY を書き出してください。"},
    {"ply.pieces_text",
     "a PLY of text is not read in pieces: export it in binary form, or read it whole with --no-stream "
     "where there is memory for it",
     "テキストの PLY は、分割しては読めません。バイナリで書き出すか、メモリーが足りるなら --no-stream で全"
     "体を読んでください。"},
    {"ply.pieces_corners", "faces of more than three corners are not read in pieces: export triangles",
     "三つより多い頂点を持つ面は、分割しては読めません。三角形で書き出してください。"},
    {"ply.no_whole_numbers", "the {name} of this PLY are no list of whole numbers",
     "この PLY の {name} は整数のリストではありません。"},
    {"ply.no_xyz", "the vertices of this PLY have no x, y and z", "この PLY の頂点に x、y、z がありません。"},
    {"ply.cut_off", "{place}the file is cut off or damaged at {where}; copy or export it again",
     "{place}ファイルが {where} で切れているか、壊れています。もう一度コピーまたは書き出しをしてください。"},
    {"ply.no_number", "{place}{word} is no number that can stand in {where}",
     "{place}{word} は {where} に入る数値ではありません。"},
    {"ply.element_of", "{name} {number} of {count}", "{name} {count} 個のうち {number} 個目"},
    {"ply.face", "face", "面"},
    {"ply.strip", "triangle strip", "三角形ストリップ"},
};

}  // namespace

std::span<const Wording> words_of_ply() {
    return kWordsOfPly;
}

}  // namespace snug
