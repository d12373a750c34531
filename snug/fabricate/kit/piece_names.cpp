#include "snug/fabricate/kit/piece_names.h"

namespace snug {

std::string pack_stem(Piece piece) {
    if (piece.middle()) return "middle-" + std::to_string(piece.index);
    return piece.highest() ? "lid" : "lower";
}

std::string foam_stem(Piece piece) {
    return piece.highest() ? "upper" : pack_stem(piece);
}

}  // namespace snug
