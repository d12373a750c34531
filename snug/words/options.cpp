#include "snug/words/catalogue.h"

// What an option may be, on the command line and in a file.

namespace snug {
namespace {

constexpr Wording kWordsOfOptions[] = {
    {"option.with_unit", "{value} {unit}", "{value} {unit}"},
    {"option.out_of_range", "{label} is {value}, but must be {bounds}",
     "{label}が {value} になっています。使える範囲は{bounds}です。"},
    {"option.above", "above {least} and at most {most}", " {least} より大きく {most} 以下"},
    {"option.zero_or", "0, or from {least} to {most}", " 0、または {least} から {most} まで"},
    {"option.from", "from {least} to {most}", " {least} から {most} まで"},
    {"option.not_a_word", "{label} must be {words/}, not {found}",
     "{label}は {words/} のどれかにしてください（指定：{found}）。"},
    {"takes", "{flag} takes {what}, not {found}", "{flag} に指定できるのは{what}です（指定：{found}）。"},
    {"takes.nothing", "nothing", "値なし"},
    {"takes.whole", "a whole number", "整数"},
    {"takes.whole_from_0", "a whole number from 0 upward", "0 以上の整数"},
    {"takes.number", "a number", "数値"},
    {"takes.number_of", "a number of {unit}", "数値（{unit}）"},
    {"takes.text", "a text", "文字列"},
    {"takes.two_lengths", "two lengths such as {example}", "{example} のような二つの長さ"},
    {"takes.length_and_width", "length and width in mm such as {example}",
     "{example} のような長さと幅（mm）"},
    {"takes.three_numbers", "three numbers such as {example}", "{example} のような三つの数値"},
    {"takes.clearance",
     "one number of mm, three (x,y,z) or six (x,y,z of the lower foam, then of the upper) such as {example} "
     "or {other}",
     "一つの数値（mm）、三つ（x,y,z）、または六つ（下のフォームの x,y,z、上のフォームの x,y,z）の数値で、"
     "{example} や {other} のような形"},
    {"takes.walls",
     "one number of mm, three (x,y,z) or six (floor,roof,back,front,left,right) such as {example} or {other}",
     "一つの数値（mm）、三つ（x,y,z）、または六つ（底,上,奥,手前,左,右）の数値で、{example} や {other} のよう"
     "な形"},
    {"takes.plane", "a direction and a distance such as {example}", "{example} のような方向と距離"},
    {"takes.ranges", "numbers and ranges from 1 upward such as {example}",
     "{example} のような 1 以上の番号と範囲"},
    {"takes.words", "words such as {example}", "{example} のような語"},
    {"takes.pieces", "sizes and pieces such as {example}", "{example} のような大きさと数"},
    {"takes.weights", "{words/}, each with a weight if you like, as in {example}",
     "{words/}（{example} のように重みを付けることもできます）"},
    {"takes.one_of", "{words/}", " {words/} のどれか"},
    {"takes.or", "{what}, or {none}", "{what}、または {none} "},
    {"takes.notches", "width x depth in mm, and the room outwards if you like, such as {example} or {other}",
     "幅 x 深さ（mm）、必要なら外への奥行きを加えた、{example} や {other} のような形"},
    {"takes.places", "one or two numbers of mm such as {example} or {other}",
     "{example} や {other} のような一つか二つの数値（mm）"},
    {"takes.case",
     "length, width and height inside in mm, with the lid's part of the height if it is known, such as "
     "{example}, or a name that `snug cases` lists",
     "内側の長さ、幅、高さ（mm、わかればふたの高さも）の {example} のような形、または `snug cases` "
     "にある名前"},
    {"takes.price",
     "the price of a litre as a number, with the currency behind it if you like, such as {example} or "
     "{other}",
     "{example} や {other} のような、リットル単価の数値（後に通貨を付けることもできます）"},
    {"takes.set", "an option's path and its value such as {example}",
     "{example} のような、設定項目の名前とその値"},
    {"flag.no_option", "{flag} says nothing about a design", "{flag} は設計の指定ではありません。"},
    {"flag.belongs_to", "{flag} belongs to {other}", "{flag} は {other} と一緒に使います。"},
    {"flag.case_or_blocks", "--case and --blocks exclude each other: the case decides how many blocks go in",
     "--case と --blocks は一緒に使えません。ブロックの数はケースで決まります。"},
    {"flag.needs_case", "--case-play, --case-radius, --case-base and --case-top belong to --case LxWxH[:LID]",
     "--case-play、--case-radius、--case-base、--case-top は --case LxWxH[:LID] と一緒に使います。"},
    {"json.invalid", "this is not valid JSON (cut off, or edited by hand?)",
     "正しい JSON ではありません（途中で切れているか、手で編集されていませんか）。"},
    {"json.must_be", "{path} must be {expected}", "{path} に指定できるのは{expected}です。"},
    {"json.not_an_object", "{path} must be a JSON object",
     "{path} は JSON のオブジェクトでなければなりません。"},
    {"json.the_file", "the file", "ファイル"},
    {"json.unknown", "{path} is not an option that this version of Snug knows",
     "{path} は、この版の Snug にはない項目です。"},
    {"json.missing", "{path} is missing", "{path} がありません。"},
    {"json.null", "null", " null "},
    {"json.true_or_false", "true or false", " true または false "},
    {"json.whole_from_0", "a whole number of 0 or more", "0 以上の整数"},
    {"json.seed", "0 to 2147483647", " 0 から 2147483647 まで"},
    {"json.length_and_width", "two numbers in brackets (length, width)",
     "角括弧に入れた二つの数値（長さ、幅）"},
    {"json.width_and_length", "two numbers in brackets (width, length)",
     "角括弧に入れた二つの数値（幅、長さ）"},
    {"json.three", "three numbers in brackets", "角括弧に入れた三つの数値"},
    {"json.three_whole", "three whole numbers in brackets", "角括弧に入れた三つの整数"},
    {"json.four", "four numbers in brackets", "角括弧に入れた四つの数値"},
    {"json.walls", "a number, six numbers in brackets", "数値、または角括弧に入れた六つの数値"},
    {"json.clearance", "a number, or six in brackets (x, y, z of the lower foam, then of the upper)",
     "数値、または角括弧に入れた六つの数値（下のフォームの x、y、z、上のフォームの x、y、z）"},
    {"json.weights", "an object with numbers for {words/}", " {words/} の数値を持つオブジェクト"},
    {"json.whole_list", "a list of whole numbers", "整数のリスト"},
    {"json.text_list", "a list of texts", "文字列のリスト"},
    {"json.pieces", "names with a whole number each", "名前と整数の組"},
    {"json.above_0", "above 0", " 0 より大きい数値"},
    {"json.word", "a word", "語"},
    {"json.version_1", "the version number 1", "版の番号 1 "},
    {"json.plain_name", "a file name without folders", "フォルダーを含まないファイル名"},
    {"json.sha256", "64 hexadecimal digits", "64 桁の十六進数"},
    {"project.newer",
     "the project is of version {version}, newer than this Snug understands (1): update Snug",
     "プロジェクトは版 {version} で、この Snug が扱える版（1）より新しいものです。Snug を更新してください。"},
};

}  // namespace

std::span<const Wording> words_of_options() {
    return kWordsOfOptions;
}

}  // namespace snug
