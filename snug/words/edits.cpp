#include "snug/words/catalogue.h"

// What a hand changes of the foams.

namespace snug {
namespace {

constexpr Wording kWordsOfEdits[] = {
    {"takes.edits",
     "a piece, a column and how many blocks to take out, such as {example}, or to put back: {other}",
     "緩衝材、列、取り除くブロックの数（たとえば {example}）、または戻す数：{other}"},
    {"json.edits", "a list of edits, each with piece, j, k, blocks and perhaps under",
     "変更のリスト（それぞれ `piece`、`j`、`k`、`blocks`、必要なら `under`）"},
    {"edit.piece", "edit {edit} must be of lower, upper or middle-1 and so on, not {piece}",
     "変更 {edit} の緩衝材は `lower`、`upper`、`middle-1` などです（{piece} ではありません）"},
    {"edit.under", "edit {edit}: only a middle piece has a face below that is cut",
     "変更 {edit}：下の面が切られるのは中間の緩衝材だけです"},
    {"edit.column", "edit {edit} must be of a column from 0 to 4095",
     "変更 {edit} の列は 0 から 4095 までです"},
    {"edit.blocks", "edit {edit} must take out or put back 1 to 4096 blocks",
     "変更 {edit} で取り除くか戻すブロックは 1 から 4096 個です"},
    {"edit.many", "there may be {most} edits at most", "変更は {most} 個までです"},
    {"edit.no_piece", "there is no such piece of foam", "その緩衝材がありません"},
    {"edit.no_column", "there is no such column in the foam", "緩衝材にその列がありません"},
    {"edit.no_foam", "the piece has only {blocks} {blocks|block|blocks} there",
     "そこの緩衝材は {blocks} ブロックだけです"},
    {"edit.not_cut", "only {blocks} {blocks|block|blocks} can be put back there",
     "そこに戻せるのは {blocks} ブロックだけです"},
    {"edit.enters", "foam would enter an item, or a place that is kept free",
     "緩衝材が対象物、または空けておく場所に入ります"},
    {"edits_unapplied",
     "{edits} of {all} {all|edit|edits} by hand {edits|does|do} not apply any more; the first, {first}: "
     "{why}. They are kept "
     "in case they do again",
     "手作業の変更 {all} 件のうち {edits} 件は適用できません。最初の "
     "{first}：{why}。また適用できるときのために残してあります"},
    {"edit_in_clearance",
     "foam that was put back by hand in {columns} {columns|column|columns} enters the clearance: there at "
     "least {mm} mm of "
     "it are left",
     "手作業で戻した緩衝材が {columns} 列でクリアランスに入っています。そこに残るのは少なくとも {mm} mm "
     "です"},
};

}  // namespace

std::span<const Wording> words_of_edits() {
    return kWordsOfEdits;
}

}  // namespace snug
