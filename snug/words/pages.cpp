#include "snug/words/catalogue.h"

// What pages of all ways of working have in common: true size, tiles, headings.

namespace snug {
namespace {

constexpr Wording kWordsOfPages[] = {
    {"page.bar", "100 mm at 100 %", "100 % 印刷で 100 mm"},
    {"page.tile", "Tile {tile} of {tiles}", "{tiles} 枚中 {tile} 枚目"},
    {"page.check_first", "Drawings at true size. This page first.",
     "原寸の図です。まずこのページを印刷してください。"},
    {"page.print_true", "Print at 100 %", "100 % で印刷する"},
    {"page.measure_square",
     "In the printer's window choose \"actual size\" or 100 %, never \"fit to page\". Then measure "
     "this square with a ruler: each side must be 100 mm. If it is not, nothing that follows is "
     "right.",
     "印刷画面では「実際のサイズ」または 100 % を選びます。「用紙に合わせる」は選ばないでください。印"
     "刷したら、この正方形を定規で測ります。どの辺も 100 mm でなければ、続くページはすべて正しい大き"
     "さではありません。"},
    {"page.join_tiles", "Join the tiles", "紙をつなぐ"},
    {"page.how_to_join",
     "Tiles butt: cut one sheet along the dashed line, lay it against its neighbour so that the "
     "halves of the crosses meet, and tape. The small map in the upper right corner shows where a "
     "sheet lies; the number beyond an edge is the neighbour's. Sheets that would be empty are left "
     "out.",
     "紙は突き合わせてつなぎます。一方を破線で切り、十字の印の半分どうしが合うように隣の紙に並べて、"
     "テープで留めます。右上の小さな図は、その紙の位置を示します。縁の外の数字は隣の紙の番号です。何"
     "も描かれない紙は省いてあります。"},
    {"page.order_of_work", "Order of work", "作業の手順"},
    {"start.title", "{name}: begin with 1", "{name}：1 から始めてください"},
    {"start.document", "{file}: {title} ({pages} {pages|page|pages})", "{file}：{title}（{pages} ページ）"},
    {"start.true_size", "{file}: {title} ({pages} {pages|page|pages}, print at 100 %)",
     "{file}：{title}（{pages} ページ、100 % で印刷）"},
    {"start.folder", "{folder}: {files} {files|file|files}", "{folder}：ファイル {files} 個"},
    {"start.rest",
     "Besides: preview.svg shows the foams, the files named lower, middle or upper are their solids, "
     "report.json says all "
     "figures, and project.snug.json makes all of this again.",
     "ほかに：preview.svg は緩衝材の図、`lower`、`middle`、`upper` で始まるファイルは立体データ、report.json "
     "は数値の一覧です。"
     "project.snug.json からすべてをもう一度作れます。"},
};

}  // namespace

std::span<const Wording> words_of_pages() {
    return kWordsOfPages;
}

}  // namespace snug
