#include "snug/words/catalogue.h"

// Compressed parts of glTF files.

namespace snug {
namespace {

constexpr Wording kWordsOfGltfPacked[] = {
    {"meshopt.repeats_parts",
     "its parts packed by meshopt repeat each other to more than its size allows: save it without "
     "compression",
     "meshopt "
     "で圧縮されたデータの繰り返しが、ファイルの大きさに対して多すぎます。圧縮せずに保存してください。"},
    {"draco.not_here",
     "its geometry is packed by Draco, which cannot be read here: save it without compression",
     "形状が Draco で圧縮されており、ここでは読めません。圧縮せずに保存してください。"},
    {"draco.too_many",
     "it claims {faces} triangles in a mesh that Draco packed into {bytes} {bytes|byte|bytes}: it is "
     "damaged; export it again",
     "三角形 {faces} 個と書かれていますが、Draco で圧縮されたメッシュは {bytes} バイトしかありません。壊れ"
     "ているので、もう一度書き出してください。"},
    {"draco.points", "Draco packed points in it and no mesh: save it without compression",
     "Draco で圧縮されているのは点群で、メッシュではありません。圧縮せずに保存してください。"},
    {"meshopt.damaged", "a part packed by meshopt is damaged: export it again",
     "meshopt で圧縮されたデータが壊れています。もう一度書き出してください。"},
    {"meshopt.not_here", "it is packed by meshopt, which cannot be read here: save it without compression",
     "meshopt で圧縮されており、ここでは読めません。圧縮せずに保存してください。"},
    {"meshopt.newer",
     "it is packed by a newer codec of meshopt than EXT_meshopt_compression has, or damaged: save it "
     "without compression",
     "EXT_meshopt_compression より新しい方式の meshopt で圧縮されているか、壊れています。圧縮せずに保存し"
     "てください。"},
    {"meshopt.mode",
     "a part of it is packed by meshopt as {name}, which Snug does not read: save it without compression",
     "meshopt で {name} として圧縮されたデータがあり、Snug では読めません。圧縮せずに保存してください。"},
    {"meshopt.filter",
     "its places are packed by meshopt with the filter {filter}, which Snug does not read: save it "
     "without compression",
     "座標が meshopt のフィルター {filter} で圧縮されており、Snug では読めません。圧縮せずに保存してくださ"
     "い。"},
    {"meshopt.too_many",
     "it claims {elements} elements in a part packed by meshopt that has {bytes} {bytes|byte|bytes}: it "
     "is damaged; export it again",
     "{elements} 要素と書かれていますが、meshopt で圧縮されたデータは {bytes} バイトしかありません。壊れてい"
     "るので、もう一度書き出してください。"},
    {"meshopt.stride",
     "a part packed by meshopt has elements of {stride} bytes, which cannot be: export it again",
     "meshopt で圧縮されたデータの要素が {stride} "
     "バイトで、あり得ない大きさです。もう一度書き出してください。"},
    {"draco.no_places", "Draco packed its triangles without their places: save it without compression",
     "Draco で三角形だけが圧縮され、座標がありません。圧縮せずに保存してください。"},
    {"gltf.newer_meshopt",
     "its geometry is packed as {extension}, which Snug does not read yet: save it without compression, "
     "or with EXT_meshopt_compression",
     "形状が {extension} で圧縮されており、Snug ではまだ読めません。圧縮せずに、または "
     "EXT_meshopt_compression で保存してください。"},
    {"draco.damaged", "a mesh that Draco packed is damaged: export it again, best without compression",
     "Draco で圧縮されたメッシュが壊れています。できれば圧縮せずに、もう一度書き出してください。"},
};

}  // namespace

std::span<const Wording> words_of_gltf_packed() {
    return kWordsOfGltfPacked;
}

}  // namespace snug
