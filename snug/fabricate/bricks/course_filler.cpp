#include "snug/fabricate/bricks/course_filler.h"

#include <algorithm>
#include <limits>

namespace snug {
namespace {

/// Least number from `from` up that is `shift` beyond a multiple of `step`.
int first_on_lattice(int from, int step, int shift) {
    const int rest = ((from - shift) % step + step) % step;
    return rest == 0 ? from : from + step - rest;
}

}  // namespace

CourseFiller::CourseFiller(const BrickCourse& course, Grid<char> free)
    : course_(course), run_(free.ny(), free.nz()) {
    for (int row = 0; row < free.ny(); ++row)
        for (int column = free.nz() - 1; column >= 0; --column) {
            if (!free(row, column)) continue;
            run_(row, column) = 1 + (column + 1 < free.nz() ? run_(row, column + 1) : 0);
            ++unfilled_;
        }
}

bool CourseFiller::fits(int row, int column, int rows, int columns) const {
    if (row < 0 || column < 0 || row + rows > run_.ny() || column + columns > run_.nz()) return false;
    for (int r = row; r < row + rows; ++r)
        if (run_(r, column) < columns) return false;
    return course_.unsupported == 0 || supported_in(row, column, rows, columns) > 0;
}

int CourseFiller::supported_in(int row, int column, int rows, int columns) const {
    int count = 0;
    for (int r = row; r < row + rows; ++r)
        for (int c = column; c < column + columns; ++c) count += course_.supported(r, c);
    return count;
}

void CourseFiller::update_runs(int row, int last_column) {
    for (int column = last_column; column >= 0 && run_(row, column) > 0; --column)
        run_(row, column) = 1 + (column + 1 < run_.nz() ? run_(row, column + 1) : 0);
}

void CourseFiller::place(BrickBox::Entry& entry, int row, int column, int rows, int columns) {
    --entry.left;
    for (int r = row; r < row + rows; ++r) {
        for (int c = column; c < column + columns; ++c) run_(r, c) = 0;
        update_runs(r, column - 1);
    }
    unfilled_ -= rows * columns;
    bricks_.push_back({course_.kind, row, column, rows, columns, course_.bottom});
}

void CourseFiller::fill(std::vector<BrickBox::Entry>& entries, const Bond& bond) {
    if (course_.unsupported > 0) span(entries);
    if (bond.by_size)
        fill_by_size(entries, bond);
    else
        fill_cell_by_cell(entries, bond);
}

void CourseFiller::lay(BrickBox::Entry& entry, bool along_rows, const Bond& bond, bool on_lattice) {
    const int width = entry.part->width, length = entry.part->length;
    const int rows = along_rows ? width : length, columns = along_rows ? length : width;
    const int long_shift = bond.long_shift * length / 4;
    const int row_shift = along_rows ? bond.short_shift : long_shift;
    const int column_shift = along_rows ? long_shift : bond.short_shift;
    const int row_step = on_lattice ? rows : 1, column_step = on_lattice ? columns : 1;
    for (int row = first_on_lattice(0, row_step, row_shift); row + rows <= run_.ny(); row += row_step)
        for (int column = first_on_lattice(0, column_step, column_shift); column + columns <= run_.nz();
             column += column_step) {
            if (entry.left <= 0) return;
            if (fits(row, column, rows, columns)) place(entry, row, column, rows, columns);
        }
}

void CourseFiller::fill_by_size(std::vector<BrickBox::Entry>& entries, const Bond& bond) {
    for (BrickBox::Entry& entry : entries)
        for (const bool on_lattice : {true, false})
            for (const bool other : {false, true}) {
                if (unfilled_ == 0) return;
                if (other && entry.part->width == entry.part->length) continue;
                lay(entry, bond.along_rows != other, bond, on_lattice);
            }
}

void CourseFiller::fill_cell_by_cell(std::vector<BrickBox::Entry>& entries, const Bond& bond) {
    for (int row = 0; row < run_.ny(); ++row)
        for (int column = 0; column < run_.nz(); ++column) {
            if (run_(row, column) == 0) continue;
            // A joint at the start of a run of bricks is moved by beginning with a shorter one.
            const bool begins = column == 0 || run_(row, column - 1) == 0;
            const int most = begins && bond.long_shift > 0 ? 2 * bond.long_shift : run_.nz() + run_.ny();
            bool placed = false;
            for (const bool limited : {true, false}) {
                for (BrickBox::Entry& entry : entries) {
                    if (entry.left <= 0 || (limited && entry.part->length > most)) continue;
                    for (const bool other : {false, true}) {
                        const bool along_rows = bond.along_rows != other;
                        const int rows = along_rows ? entry.part->width : entry.part->length;
                        const int columns = along_rows ? entry.part->length : entry.part->width;
                        if (!fits(row, column, rows, columns)) continue;
                        place(entry, row, column, rows, columns);
                        placed = true;
                        break;
                    }
                    if (placed) break;
                }
                if (placed) break;
            }
        }
}

void CourseFiller::span(std::vector<BrickBox::Entry>& entries) {
    for (int row = 0; row < run_.ny(); ++row)
        for (int column = 0; column < run_.nz(); ++column)
            if (run_(row, column) > 0 && !course_.supported(row, column)) span_from(entries, row, column);
}

void CourseFiller::span_from(std::vector<BrickBox::Entry>& entries, int row, int column) {
    BrickBox::Entry* best = nullptr;
    int best_score = std::numeric_limits<int>::min();
    Brick at;
    for (BrickBox::Entry& entry : entries) {
        if (entry.left <= 0) continue;
        for (const bool along_rows : {true, false}) {
            const int rows = along_rows ? entry.part->width : entry.part->length;
            const int columns = along_rows ? entry.part->length : entry.part->width;
            for (int r = row - rows + 1; r <= row; ++r)
                for (int c = column - columns + 1; c <= column; ++c) {
                    if (!fits(r, c, rows, columns)) continue;
                    const int carried = supported_in(r, c, rows, columns), studs = rows * columns;
                    // As much without support as a piece can carry: at least as many studs hold it.
                    const int score =
                        4 * std::min(studs - carried, carried) - std::max(0, studs - 2 * carried);
                    if (score <= best_score) continue;
                    best_score = score;
                    best = &entry;
                    at = {course_.kind, r, c, rows, columns, course_.bottom};
                }
        }
    }
    if (best) place(*best, at.row, at.column, at.rows, at.columns);
}

}  // namespace snug
