#include "snug/fabricate/bricks/brick_repair.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "snug/base/seeded_numbers.h"
#include "snug/fabricate/bricks/course_filler.h"

namespace snug {
namespace {

constexpr int kMostFailures = 100;        // in a row, as in the paper
constexpr int kFailuresARing = 10;        // after which the neighbourhood grows by a ring
constexpr std::size_t kMostBricks = 300;  // of a neighbourhood

/// Two neighbouring studs of a course whose bricks belong to different pieces.
struct Seam {
    int course, row, column;
    bool right;  ///< the other stud is to the right, else nearer
};

std::vector<Seam> seams_between(const LaidBricks& laid, const std::vector<int>& piece) {
    const auto differ = [&](int a, int b) {
        return a != LaidBricks::kNone && b != LaidBricks::kNone &&
               piece[static_cast<std::size_t>(a)] != piece[static_cast<std::size_t>(b)];
    };
    std::vector<Seam> seams;
    for (int i = 0; i < laid.count(); ++i) {
        if (!laid.is_there(i)) continue;
        const Brick& brick = laid[i];
        const int course = laid.course_of(i);
        const int last_row = brick.row + brick.rows - 1, last_column = brick.column + brick.columns - 1;
        for (int row = brick.row; row <= last_row; ++row)
            if (differ(i, laid.at(course, row, last_column + 1)))
                seams.push_back({course, row, last_column, true});
        for (int column = brick.column; column <= last_column; ++column)
            if (differ(i, laid.at(course, last_row + 1, column)))
                seams.push_back({course, last_row, column, false});
    }
    return seams;
}

/// Those within `rings` steps from the two bricks at the seam, by sides and studs.
std::vector<int> neighbourhood(const LaidBricks& laid, const Seam& seam, int rings) {
    std::vector<int> found{laid.at(seam.course, seam.row, seam.column),
                           laid.at(seam.course, seam.row + !seam.right, seam.column + seam.right)};
    const auto add = [&found](int brick) {
        if (brick == LaidBricks::kNone || found.size() >= kMostBricks) return;
        if (std::find(found.begin(), found.end(), brick) == found.end()) found.push_back(brick);
    };
    std::size_t begin = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const std::size_t end = found.size();
        for (; begin < end; ++begin) {
            const Brick brick = laid[found[begin]];
            const int course = laid.course_of(found[begin]);
            for (int row = brick.row; row < brick.row + brick.rows; ++row) {
                add(laid.at(course, row, brick.column - 1));
                add(laid.at(course, row, brick.column + brick.columns));
                for (int column = brick.column; column < brick.column + brick.columns; ++column) {
                    add(laid.below(course, row, column));
                    add(laid.above(course, row, column));
                }
            }
            for (int column = brick.column; column < brick.column + brick.columns; ++column) {
                add(laid.at(course, brick.row - 1, column));
                add(laid.at(course, brick.row + brick.rows, column));
            }
        }
    }
    return found;
}

/// One of the pieces that fit across the seam, any of them as likely.
void bridge(CourseFiller& filler, std::vector<BrickBox::Entry>& entries, const Seam& seam,
            SeededNumbers& numbers) {
    struct Way {
        BrickBox::Entry* entry;
        int row, column, rows, columns;
    };
    std::vector<Way> ways;
    for (BrickBox::Entry& entry : entries) {
        if (entry.left <= 0) continue;
        for (const bool turned : {false, true}) {
            if (turned && entry.part->width == entry.part->length) continue;
            const int rows = turned ? entry.part->length : entry.part->width;
            const int columns = turned ? entry.part->width : entry.part->length;
            for (int row = seam.row + !seam.right - rows + 1; row <= seam.row; ++row)
                for (int column = seam.column + seam.right - columns + 1; column <= seam.column; ++column)
                    if (filler.fits(row, column, rows, columns))
                        ways.push_back({&entry, row, column, rows, columns});
        }
    }
    if (ways.empty()) return;
    const Way& way = ways[static_cast<std::size_t>(numbers.below(static_cast<int>(ways.size())))];
    filler.place(*way.entry, way.row, way.column, way.rows, way.columns);
}

/// Lays the removed bricks' cells again, course by course; false where something stays free.
bool lay_again(const std::vector<BrickCourse>& courses, LaidBricks& laid, const std::vector<int>& removed,
               const std::vector<int>& course_of, const Seam& seam, BrickBox& box, SeededNumbers& numbers,
               std::vector<int>& added) {
    std::vector<int> in_order = course_of;
    std::sort(in_order.begin(), in_order.end());
    in_order.erase(std::unique(in_order.begin(), in_order.end()), in_order.end());
    for (const int number : in_order) {
        const BrickCourse& course = courses[static_cast<std::size_t>(number)];
        Grid<char> free(course.cells.ny(), course.cells.nz());
        for (std::size_t i = 0; i < removed.size(); ++i) {
            if (course_of[i] != number) continue;
            const Brick& brick = laid[removed[i]];
            for (int row = brick.row; row < brick.row + brick.rows; ++row)
                for (int column = brick.column; column < brick.column + brick.columns; ++column)
                    free(row, column) = 1;
        }
        CourseFiller filler(course, std::move(free));
        auto& entries = box.of(course.kind);
        if (number == seam.course) bridge(filler, entries, seam, numbers);
        filler.fill(entries,
                    {numbers.below(2) == 0, numbers.below(4) > 0, numbers.below(4), numbers.below(2)});
        if (filler.unfilled() > 0) return false;
        for (const Brick& brick : filler.bricks()) added.push_back(laid.add(number, brick));
    }
    return true;
}

}  // namespace

int join_pieces(const std::vector<BrickCourse>& courses, LaidBricks& laid, BrickBox& box) {
    SeededNumbers numbers(1);
    int pieces = 0, failures = 0;
    std::vector<Seam> seams;
    const auto look_again = [&](const std::pair<std::vector<int>, int>& found) {
        pieces = found.second;
        seams = pieces > 1 ? seams_between(laid, found.first) : std::vector<Seam>();
    };
    look_again(laid.pieces());
    while (!seams.empty() && failures < kMostFailures) {
        const Seam seam = seams[static_cast<std::size_t>(numbers.below(static_cast<int>(seams.size())))];
        const std::vector<int> removed = neighbourhood(laid, seam, failures / kFailuresARing + 1);
        std::vector<int> course_of, added;
        const BrickBox before = box;
        for (const int brick : removed) {
            course_of.push_back(laid.course_of(brick));
            box.put_back(laid[brick]);
            laid.remove(brick);
        }
        const bool filled = lay_again(courses, laid, removed, course_of, seam, box, numbers, added);
        if (filled) {
            const auto found = laid.pieces();
            if (found.second < pieces) {
                look_again(found);
                failures = 0;
                continue;
            }
        }
        for (const int brick : added) laid.remove(brick);
        for (std::size_t i = 0; i < removed.size(); ++i) {
            const Brick brick = laid[removed[i]];
            laid.add(course_of[i], brick);
        }
        box = before;
        ++failures;
    }
    return pieces;
}

}  // namespace snug
