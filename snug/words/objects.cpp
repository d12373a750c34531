#include "snug/words/catalogue.h"

// What is known of the object, and what was done to it.

namespace snug {
namespace {

constexpr Wording kWordsOfObjects[] = {
    {"left_out/faces",
     "{left_out} of {faces} {faces|face|faces} of the file were left out: they have fewer than three "
     "corners, or a corner whose place is no number. Look whether the object is whole, or repair it and "
     "export it again",
     "ファイルの {faces} 面のうち {left_out} 面を除きました。頂点が三つに満たないか、座標が数値でない頂点"
     "があります。対象物が欠けていないか確かめるか、修復してもう一度書き出してください。"},
    {"left_out/points",
     "{left_out} of {points} {points|point|points} of the file were left out: their places are no "
     "numbers. Look whether the object is whole, or scan it again",
     "ファイルの {points} 点のうち {left_out} 点を除きました。座標が数値ではありません。対象物が欠けていな"
     "いか確かめるか、もう一度スキャンしてください。"},
    {"left_out_objects",
     "there are several objects in the file, and the foams are for one of them: {names,}{more} "
     "{objects|is|are} left out. Make foams for each by itself",
     "ファイルに複数の対象物があり、緩衝材はそのうちの一つのものです。除いたもの：{names,}{more}。それぞ"
     "れ別に緩衝材を作ってください。"},
    {"and_more", " and {count} more", "、ほか {count} 件"},
    {"no_end",
     "the file stops without \"endsolid\", so its end may be missing: look whether the object is whole, or "
     "copy or export it again",
     "ファイルが \"endsolid\" なしで終わっており、末尾が欠けているかもしれません。対象物が欠けていないか確か"
     "めるか、もう一度コピーまたは書き出しをしてください。"},
    {"unit_stated",
     "the design says that the file is in {unit}, but the file states its unit itself, and that counts. "
     "If the object has the wrong size, choose its scale or its longest side",
     "設計ではファイルの単位は {unit} ですが、ファイル自体に単位の記載があり、そちらを使います。大きさが違"
     "うときは、倍率か最も長い辺を指定してください。"},
    {"capped",
     "{holes} {holes|hole was|holes were} closed before cutting; where the surface is missing its shape "
     "is a guess",
     "切る前に {holes} 個の穴をふさぎました。表面のない所の形は推定です。"},
    {"nothing_to_cap",
     "the object has no holes, so there was nothing to close: the foams are the same without --cap",
     "対象物に穴がないため、ふさぐものがありません。--cap がなくても緩衝材は同じです。"},
    {"no_points", "a point radius was chosen, but the object is no cloud of points: it was not used",
     "点の半径が指定されていますが、対象物は点群ではないため使いませんでした。"},
    {"cloud",
     "a cloud of {points} {points|point|points}: each counts as a ball, half of them of {radius} mm or "
     "less in radius (--point-radius sets it). Volume, parts, gaps and undercuts are not known",
     "{points} 点の点群です。各点を球とみなし、その半数は半径 {radius} mm 以下です（--point-radius で指定"
     "できます）。体積、部品、すきま、陰になる所はわかりません。"},
    {"capped/cloud",
     "what the scanner did not see was closed before cutting, down to the end of the object where that is "
     "near; its shape there is a guess",
     "スキャナーから見えなかった所を、対象物の端が近ければそこまで、切る前にふさぎました。そこの形は推定で"
     "す。"},
    {"nothing_to_cap/cloud",
     "no place was found that the scanner did not see, so there was nothing to close: the foams are the "
     "same without --cap",
     "スキャナーから見えなかった所は見つからず、ふさぐものがありません。--cap "
     "がなくても緩衝材は同じです。"},
    {"streamed",
     "the object was read in pieces: whether it is closed, in how many parts, and what it has of "
     "undercuts is not known; foam may grow inside where it is open",
     "対象物を分割して読み込みました。閉じているか、部品の数、陰になる所はわかりません。開いている所では"
     "内側に緩衝材が残ることがあります。"},
    {"nothing_dropped",
     "no part of the object is smaller than {below} mm, so none was left out: the smallest is {smallest} "
     "mm long",
     "{below} mm より小さい部品はないため、何も除いていません。最も小さい部品の長さは {smallest} mm です。"},
    {"cut_missed",
     "the cutting plane meets nothing, so nothing was cut off: it lies {distance} mm from the file's "
     "origin along {direction}, and the object lies from {nearest} to {farthest} mm; choose a distance "
     "between these",
     "平面が対象物と交わらないため、何も切っていません。平面はファイルの原点から {direction} の方向に "
     "{distance} mm、対象物は {nearest}～{farthest} mm にあります。その間の距離を指定してください。"},
    {"dropped",
     "{parts} {parts|part was|parts were} left out, as asked: at most {longest} mm long, together "
     "{percent} % of the surface",
     "指定により {parts} 個の部品を除きました。長さは最大 {longest} mm、合わせて表面の {percent} % です。"},
    {"cut_off", "what lay behind the cutting plane was left out, as asked, and the cut closed",
     "指定により、平面の裏側を除き、切り口をふさぎました。"},
    {"object_changed", "the object {name} is not the one that the project was made with: check the result",
     "対象物 {name} は、プロジェクトを作ったときのものと違います。結果を確かめてください。"},
    {"searched_stand_in",
     "the search worked with a stand-in that holds the object, so its own figures are a little too high; "
     "the foams are of the object itself",
     "探索には対象物を包むコピーを使ったため、探索の数値は少し大きめです。緩衝材は対象物そのものから作りま"
     "した。"},
    {"clean.all_behind",
     "the whole object lies behind the cutting plane: turn its direction round, or move it",
     "対象物全体が平面の裏側にあります。向きを反対にするか、平面を動かしてください。"},
    {"clean.cloud", "a point cloud has no parts to drop; a plane can cut it",
     "点群には除く部品がありません。平面で切ることはできます。"},
    {"clean.nothing_left", "every part of the object would be dropped: name fewer, or a smaller size",
     "すべての部品が除かれます。除く番号を減らすか、大きさを小さくしてください。"},
    {"clean.no_part",
     "there is no part {number} to drop: the object has {parts} {parts|part|parts} (see `snug inspect`)",
     "除く部品 {number} がありません。対象物の部品は {parts} 個です（`snug inspect` で確かめられます）。"},
    {"object.one_point", "the object has no size: all its points are one",
     "すべての点が一か所にあり、対象物に大きさがありません。"},
    {"cloud.radius", "the radius of a point must be 0 mm (from the spacing) or more",
     "点の半径は 0 mm（間隔から決める）以上にしてください。"},
    {"pieces.clean",
     "parts cannot be dropped from an object that is read in pieces, nor can it be cut by a plane",
     "分割して読み込む対象物からは、部品を除くことも、平面で切ることもできません。"},
    {"pieces.cap", "holes cannot be closed in an object that is read in pieces",
     "分割して読み込む対象物の穴はふさげません。"},
    {"unit.implausible",
     "the object would be {size} mm, {problem}. Which unit is it in? Read as mm it measures {mm} mm, as "
     "cm it measures {cm} mm, as m it measures {m} mm, or as in it measures {in} mm. Choose with --units "
     "mm|cm|m|in",
     "対象物の大きさが {size} mm になり、{problem}。単位を確かめてください。mm なら {mm} mm、cm なら {cm} "
     "mm、m なら {m} mm、in なら {in} mm です。--units mm|cm|m|in で選んでください。"},
    {"unit.tiny", "smaller than one block", "ブロック一つより小さくなります"},
    {"unit.huge", "longer than 5 m", "5 m を超えます"},
};

}  // namespace

std::span<const Wording> words_of_objects() {
    return kWordsOfObjects;
}

}  // namespace snug
