#include "snug/fabricate/sheets/sheet_stack.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr double kSameLength = 1e-6;    // of it
constexpr double kThinnestSheet = 0.1;  // mm
constexpr std::size_t kMostPieces = 20000;

std::string mm(double value) {
    return number(value, 3) + " mm";
}

/// The levels of the highest piece.
int most_levels_of(const FoamDesign& design) {
    int most = 0;
    for (const Piece piece : design.foams.all())
        for (const Run kept : design.seen(piece).kept) most = std::max<int>(most, kept.end);
    return most;
}

/// "7.5 mm or 15 mm"
Message either(double thinner, double thicker) {
    return say("sheets.either", {{"thinner", mm(thinner)}, {"thicker", mm(thicker)}});
}

/// "7.5 mm or 15 mm", or the one that works.
Message nearest_thicknesses(double wanted, double depth, int most_levels) {
    if (wanted < depth) {
        const double parts = std::floor(depth / wanted);
        return either(depth / (parts + 1), depth / parts);
    }
    const double levels = std::min(std::floor(wanted / depth), static_cast<double>(most_levels));
    if (levels >= most_levels) return as_it_is(mm(levels * depth));
    return either(levels * depth, (levels + 1) * depth);
}

class PieceFinder {
  public:
    explicit PieceFinder(const SheetStack& stack) : stack_(stack), seen_(stack.rows(), stack.columns(), -1) {}

    /// The pieces of a sheet, the largest first.
    std::vector<SheetPiece> find(int sheet) {
        std::vector<SheetPiece> pieces;
        for (int row = 0; row < stack_.rows(); ++row)
            for (int column = 0; column < stack_.columns(); ++column)
                if (open(row, column, sheet)) pieces.push_back(flood(row, column, sheet));
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const SheetPiece& a, const SheetPiece& b) { return a.cells > b.cells; });
        return pieces;
    }

  private:
    struct Cell {
        int row, column;
    };

    [[nodiscard]] bool open(int row, int column, int sheet) const {
        return seen_.contains(row, column) && stack_.has(row, column, sheet) && seen_(row, column) < sheet;
    }

    SheetPiece flood(int row, int column, int sheet) {
        found_.assign(1, {row, column});
        seen_(row, column) = sheet;
        Cell least{row, column}, most{row, column};
        for (std::size_t next = 0; next < found_.size(); ++next) {
            const Cell at = found_[next];
            least = {std::min(least.row, at.row), std::min(least.column, at.column)};
            most = {std::max(most.row, at.row), std::max(most.column, at.column)};
            for (const Cell to : {Cell{at.row - 1, at.column}, Cell{at.row, at.column - 1},
                                  Cell{at.row, at.column + 1}, Cell{at.row + 1, at.column}}) {
                if (!open(to.row, to.column, sheet)) continue;
                seen_(to.row, to.column) = sheet;
                found_.push_back(to);
            }
        }
        SheetPiece piece;
        piece.sheet = sheet;
        piece.column = least.column;
        piece.row = least.row;
        piece.mask = Mask(most.column - least.column + 1, most.row - least.row + 1);
        for (const Cell at : found_) piece.mask.set(at.column - least.column, at.row - least.row);
        piece.cells = static_cast<int>(found_.size());
        piece.loops = cell_loops(piece.mask);
        return piece;
    }

    const SheetStack& stack_;
    Grid<int> seen_;  ///< the last sheet in which a cell was found
    std::vector<Cell> found_;
};

/// a, b ... z, aa, ab ...
std::string island_letters(std::size_t number) {
    std::string letters;
    for (std::size_t rest = number + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('a' + (rest - 1) % 26));
    return letters;
}

/// The sheets that each column keeps, as the half is seen, and what is lost by whole sheets.
void count_sheets(const FoamDesign& design, const SheetMeasure& measure, SheetStack& stack) {
    const Grid<Run> runs = design.seen(stack.piece).kept;
    stack.kept = Grid<int>(runs.ny(), runs.nz(), 0);
    stack.missing = stack.kept;
    for (int row = 0; row < stack.rows(); ++row) {
        const int j = stack.piece.half() == Half::lower ? row : stack.rows() - 1 - row;
        for (int k = 0; k < stack.columns(); ++k) {
            const Run blocks = runs(j, k);
            const int first = (blocks.first + measure.levels - 1) / measure.levels;
            const int end = blocks.end / measure.levels;
            if (first < end) {
                stack.kept(row, k) = end * measure.parts;
                stack.count = std::max(stack.count, end * measure.parts);
                stack.missing(row, k) = first * measure.parts;
            }
            stack.lost_blocks += blocks.blocks() - std::max(0, end - first) * measure.levels;
        }
    }
}

void name_pieces(std::vector<SheetPiece>& of_a_sheet, int sheet, const std::string& sheet_name) {
    for (std::size_t i = 0; i < of_a_sheet.size(); ++i) {
        SheetPiece& piece = of_a_sheet[i];
        piece.sheet = sheet;
        piece.island = i > 0;
        piece.name = sheet_name + (i > 0 ? island_letters(i - 1) : "");
    }
}

}  // namespace

std::string SheetStack::sheet_name(int sheet) const {
    const std::string letter = piece.middle()    ? "M" + std::to_string(piece.index) + "-"
                               : piece.highest() ? "U"
                                                 : "L";
    return letter + std::to_string(sheet + 1);
}

Result<SheetMeasure> sheet_measure(const FoamDesign& design, double thickness_mm) {
    const double depth = design.space.block_mm.x;
    const int most = most_levels_of(design);
    if (most == 0) return fail(ErrorKind::usage, say("sheets.no_foam"));
    const double share = thickness_mm >= depth ? thickness_mm / depth : depth / thickness_mm;
    const double whole = std::floor(share + 0.5);
    const bool fits = std::fabs(share - whole) <= kSameLength * share;
    const bool thin = thickness_mm < depth && whole > 1;
    if (!fits || (!thin && whole > most) || thickness_mm < kThinnestSheet)
        return fail(
            ErrorKind::usage,
            say("sheets.thickness",
                {{"thickness", mm(thickness_mm)},
                 {"depth", mm(depth)},
                 {"thickest", mm(most * depth)},
                 {"nearest", nearest_thicknesses(std::max(thickness_mm, kThinnestSheet), depth, most)}}));
    const int count = static_cast<int>(whole);
    return thin ? SheetMeasure{thickness_mm, 1, count} : SheetMeasure{thickness_mm, count, 1};
}

std::vector<SheetPiece> sheet_pieces(const SheetStack& stack, int sheet, const std::string& sheet_name) {
    std::vector<SheetPiece> pieces = PieceFinder(stack).find(sheet);
    name_pieces(pieces, sheet, sheet_name);
    return pieces;
}

Result<SheetStack> sheet_stack(const FoamDesign& design, Piece piece, const SheetMeasure& measure) {
    SheetStack stack;
    stack.piece = piece;
    stack.cell_mm = {design.space.block_mm.z, design.space.block_mm.y};
    stack.levels = measure.levels;
    count_sheets(design, measure, stack);
    PieceFinder finder(stack);
    for (int sheet = 0; sheet < stack.count; sheet += measure.parts) {
        std::vector<SheetPiece> found = finder.find(sheet);
        if (stack.pieces.size() + found.size() * static_cast<std::size_t>(measure.parts) > kMostPieces)
            return fail(ErrorKind::usage, say("sheets.too_many_pieces", {{"most", kMostPieces}}));
        for (int part = 0; part < measure.parts; ++part) {
            name_pieces(found, sheet + part, stack.sheet_name(sheet + part));
            stack.pieces.insert(stack.pieces.end(), found.begin(), found.end());
        }
    }
    return stack;
}

}  // namespace snug
