#pragma once

#include <string>

#include "snug/base/message.h"
#include "snug/base/piece.h"

namespace snug {

/// `of_a_middle` with the piece's number where it lies between two layers.
[[nodiscard]] inline Message piece_text(Piece piece, const char* lower, const char* of_a_middle,
                                        const char* lid) {
    if (piece.middle()) return say(of_a_middle, {{"number", std::to_string(piece.index)}});
    return say(piece.highest() ? lid : lower);
}

/// "lower foam", "middle foam 1", "lid"
[[nodiscard]] inline Message foam_of(Piece piece) {
    return piece_text(piece, "foam.lower", "foam.middle", "foam.lid");
}

/// "lower half", "middle foam 1", "lid"
[[nodiscard]] inline Message half_of(Piece piece) {
    return piece_text(piece, "foam.lower_half", "foam.middle", "foam.lid");
}

/// How pages call a piece by what is written on it: "LOWER", "MIDDLE 1", "LID"
[[nodiscard]] inline Message marked_piece(Piece piece) {
    return piece_text(piece, "mark.lower", "mark.middle", "mark.lid");
}

/// The same of one side of it: "MIDDLE 1 from below"
[[nodiscard]] inline Message marked_side(Piece piece, Half from) {
    if (!piece.middle()) return marked_piece(piece);
    return say(from == Half::lower ? "mark.middle_from_above" : "mark.middle_from_below",
               {{"number", std::to_string(piece.index)}});
}

}  // namespace snug
