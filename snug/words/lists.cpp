#include "snug/words/catalogue.h"

// What commands print besides the summary of a design: lines of `snug inspect`, lists, work that goes on.

namespace snug {
namespace {

constexpr Wording kWordsOfLists[] = {
    {"status.percent", "{work} {percent} %", "{work} {percent} %"},
    {"status.reading", "Reading", "読み込み中"},
    {"status.reading_file", "Reading {file}", "{file} を読み込み中"},
    {"status.measuring", "Measuring", "測定中"},
    {"status.cutting", "Cutting", "切り取り中"},
    {"status.gaps", "Measuring gaps", "すきまを測定中"},
    {"status.workshop", "Drawing for the workshop", "製作用の図を作成中"},
    {"status.bricks", "Checking how firmly the bricks hold", "ブロックの強さを確認中"},
    {"status.writing", "Writing", "書き出し中"},
    {"status.thinning", "Thinning", "間引き中"},
    {"status.thinning_file", "Thinning {file}", "{file} を間引き中"},
    {"status.searching", "Searching {percent} %: {blocks} blocks cut",
     "探索中 {percent} %：切り取り {blocks} ブロック"},
    {"status.arranging", "Arranging {percent} %{best}", "並べています {percent} %{best}"},
    {"status.litres", ": {litres} litres", "：{litres} リットル"},
    {"status.fitting", "Fitting the case {percent} %", "ケースを合わせています {percent} %"},
    {"inspect.size", "Size", "大きさ"},
    {"inspect.size_stated", "{size} mm; the file states its unit", "{size} mm（ファイルに単位の記載あり）"},
    {"inspect.size_if", "Size, if the file is in", "大きさ、ファイルの単位が次の場合"},
    {"inspect.likely", "   <- likely", "   ← ありそう"},
    {"inspect.volume", "Volume", "体積"},
    {"inspect.no_volume", "unknown: the surface is not closed", "不明：表面が閉じていません"},
    {"inspect.volume_if", "Volume, if the file is in", "体積、ファイルの単位が次の場合"},
    {"inspect.cloud", "A cloud of {points} {points|point|points}", "{points} 点の点群"},
    {"inspect.triangles", "Triangles", "三角形"},
    {"inspect.triangles_of", "{triangles} with {vertices} {vertices|vertex|vertices}",
     "{triangles} 個、頂点 {vertices} 個"},
    {"inspect.holes", "Holes", "穴"},
    {"inspect.closed", "Closed", "閉じている"},
    {"inspect.yes", "yes", "はい"},
    {"inspect.no", "no", "いいえ"},
    {"inspect.wound", "no: its triangles are wound both ways", "いいえ：面の向きが不揃いです"},
    {"inspect.parts", "Parts", "部品"},
    {"inspect.part",
     "{size} in {unit}, {triangles} {triangles|triangle|triangles}, {percent} % of the surface",
     "{size}（{unit}）、三角形 {triangles} 個、表面の {percent} %"},
    {"inspect.reaches", "Lies", "位置"},
    {"inspect.from_to", "from {from} to {to} in {unit}", "{from} から {to} まで（{unit}）"},
    {"inspect.file_unit", "the file's unit", "ファイルの単位"},
    {"inspect.smaller_parts",
     "and {parts} more, at most {longest} long, {percent} % of the surface; --json lists all",
     "ほか {parts} 個、長さは最大 {longest}、表面の {percent} %。--json ですべて表示します"},
    {"sample.written", "{file}: {vertices} {vertices|vertex|vertices}, {size} mm",
     "{file}：頂点 {vertices} 個、{size} mm"},
    {"list.name", "name", "名前"},
    {"list.block", "block x, y, z", "ブロック x、y、z"},
    {"list.clearance", "clearance", "クリアランス"},
    {"list.density", "kg/m3", "kg/m3"},
    {"list.what", "what it is", "内容"},
    {"list.rigid", "{title} (rigid: holds, does not cushion)", "{title}（硬い：支えますが緩衝しません）"},
    {"list.own_presets",
     "Add your own in {file}, for example:", "自分の緩衝材は {file} に加えてください。例："},
    {"list.kind", "kind", "種類"},
    {"list.inside", "inside L x W x H, mm", "内寸 長さ x 幅 x 高さ mm"},
    {"list.lid", "lid mm", "ふた mm"},
    {"list.most_kg", "most kg", "最大 kg"},
    {"list.price", "price", "価格"},
    {"list.carrier", "maker or carrier", "メーカー・運送会社"},
    {"list.fill", "fill", "充填"},
    {"list.billed", "billed kg", "請求 kg"},
    {"list.lay", "lay it with", "置き方"},
    {"list.own_cases",
     "Sizes differ between makers by some mm: measure yours. Add your own in {file};\n`snug cases --csv` "
     "shows its columns, name and the three sizes are required.",
     "大きさは製品によって数 mm 違います。実際に測ってください。自分のケースは {file} に加えられます。\n"
     "列は `snug cases --csv` で確かめられます。名前と三つの大きさが必要です。"},
    {"list.billed_weight",
     "Billed weight is the greater of mass and inside volume / divisor, in whole kg; a carrier measures "
     "outside.\nUse one with `snug make ... --case {name}`.",
     "請求重量は、質量と「内側の体積 ÷ 除数」の大きい方を kg に切り上げたものです。運送会社は外寸で測りま"
     "す。\n選んだケースは `snug make ... --case {name}` のように指定します。"},
    {"preset/paper", "block sponge as in the paper, 15 x 15 x 22 mm",
     "論文のブロックスポンジ 15 x 15 x 22 mm"},
    {"preset/slit-10", "slit sponge, 10 mm grid in layers of 20 mm",
     "スリットスポンジ、10 mm の格子、20 mm の層"},
    {"preset/slit-12.7", "slit sponge, half-inch grid in layers of 25.4 mm",
     "スリットスポンジ、半インチの格子、25.4 mm の層"},
    {"preset/slit-15", "slit sponge, 15 mm grid in layers of 15 mm",
     "スリットスポンジ、15 mm の格子、15 mm の層"},
    {"preset/cube-25", "loose foam cubes of 25 mm", "ばらの 25 mm 緩衝材キューブ"},
    {"preset/sheet-5", "polyethylene sheets of 5 mm, cut to contour in steps of 2.5 mm",
     "5 mm のポリエチレンシート、2.5 mm 刻みの輪郭で切断"},
    {"preset/sheet-10", "polyethylene sheets of 10 mm, cut to contour in steps of 2.5 mm",
     "10 mm のポリエチレンシート、2.5 mm 刻みの輪郭で切断"},
    {"preset/lego-brick", "toy bricks on an 8 mm pitch, 9.6 mm high", "ブロック玩具、8 mm 間隔、高さ 9.6 mm"},
    {"preset/lego-plate", "toy plates on an 8 mm pitch, 3.2 mm high",
     "ブロック玩具の薄いプレート、8 mm 間隔、高さ 3.2 mm"},
    {"preset/print", "3D print in steps of 2 mm", "3D プリント、2 mm 刻み"},
    {"preset/mill", "polyethylene block, milled in columns of 2 mm and steps of 5 mm",
     "ポリエチレンのブロック、2 mm の柱と 5 mm 刻みで切削"},
    {"preset/cast", "foam or silicone, poured into printed moulds in steps of 5 mm",
     "発泡樹脂またはシリコーン、印刷した型に流し込み、5 mm 刻み"},
    {"kind.carton", "carton", "段ボール箱"},
    {"kind.hard_case", "hard case", "ハードケース"},
    {"kind.parcel_class", "parcel class", "小包の規格"},
    {"studio.thinned",
     "{file} is too large for a page: it shows a copy of {triangles} triangles that lies at most {off} (in "
     "the file's unit) off. Foams are made from the original by `snug make`.",
     "{file} は画面で扱うには大きすぎるため、三角形 {triangles} 個のコピーを表示します（ずれは最大 "
     "{off}、ファ"
     "イルの単位）。緩衝材は `snug make` で元のデータから作ってください。"},
    {"studio.at", "Snug Studio is at {address}\nIt is for this machine alone. Ctrl-C ends it.",
     "Snug スタジオのアドレス：{address}\nこの計算機でだけ使えます。Ctrl-C で終わります。"},
    {"inspect.danger", "danger", "危険"},
    {"inspect.warning", "warning", "警告"},
    {"inspect.note", "note", "参考"},
};

}  // namespace

std::span<const Wording> words_of_lists() {
    return kWordsOfLists;
}

}  // namespace snug
