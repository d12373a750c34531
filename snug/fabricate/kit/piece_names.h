#pragma once

#include <string>

#include "snug/base/piece.h"

namespace snug {

/// How the files of packs call a piece: "lower", "middle-1", "lid".
[[nodiscard]] std::string pack_stem(Piece piece);

/// How the files of the foams themselves, the report and depths.csv call it: "lower", "middle-1", "upper".
[[nodiscard]] std::string foam_stem(Piece piece);

}  // namespace snug
