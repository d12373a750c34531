#include "snug/fabricate/bricks/brick_layout.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "snug/base/text.h"
#include "snug/fabricate/bricks/brick_courses.h"
#include "snug/fabricate/bricks/brick_repair.h"
#include "snug/fabricate/bricks/course_filler.h"
#include "snug/fabricate/bricks/laid_bricks.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr long long kMostStuds = 4'000'000;  // of both halves: more are built by nobody
constexpr long long kEnough = std::numeric_limits<int>::max();

/// Ways to fill a course; the first suits the course's place in the bond, the others are tried beside it.
std::array<Bond, 10> bonds(int course) {
    const bool along = course % 2 == 0;
    const int shift = course / 2 % 2;
    return {{{along, true, 2 * shift, shift},
             {along, true, 2 - 2 * shift, shift},
             {along, true, 1 + 2 * shift, 1 - shift},
             {along, true, 0, 0},
             {along, true, 2, 1},
             {!along, true, 2 * shift, shift},
             {!along, true, 2 - 2 * shift, 1 - shift},
             {along, false, 2 * shift, 0},
             {along, false, 2 - 2 * shift, 0},
             {!along, false, 2 * shift, 0}}};
}

/// Which brick of another course lies under each cell, kNone for none.
Grid<int> bricks_below(const BrickCourse& course, int number, const LaidBricks& laid) {
    Grid<int> below(course.cells.ny(), course.cells.nz(), LaidBricks::kNone);
    for (int row = 0; row < below.ny(); ++row)
        for (int column = 0; column < below.nz(); ++column)
            if (course.cells(row, column)) below(row, column) = laid.below(number, row, column);
    return below;
}

/// Sides of studs where a joint of this course lies above one of the course below.
int aligned_joints(const BrickCourse& course, const std::vector<Brick>& bricks, const Grid<int>& below) {
    Grid<int> own(course.cells.ny(), course.cells.nz(), LaidBricks::kNone);
    for (std::size_t i = 0; i < bricks.size(); ++i)
        for (int row = bricks[i].row; row < bricks[i].row + bricks[i].rows; ++row)
            for (int column = bricks[i].column; column < bricks[i].column + bricks[i].columns; ++column)
                own(row, column) = static_cast<int>(i);
    int aligned = 0;
    const auto joint = [](const Grid<int>& grid, int j, int k, int j2, int k2) {
        return grid(j, k) != LaidBricks::kNone && grid(j2, k2) != LaidBricks::kNone &&
               grid(j, k) != grid(j2, k2);
    };
    for_each_side(own, [&](int j, int k, int j2, int k2, bool) {
        aligned += joint(own, j, k, j2, k2) && joint(below, j, k, j2, k2);
    });
    return aligned;
}

/// The best of all bonds: first that nothing stays free, then few bricks with few joints above joints.
struct Filled {
    std::vector<Brick> bricks;
    std::vector<BrickBox::Entry> entries;
    int unfilled = 0;
    double cost = std::numeric_limits<double>::infinity();
};

Filled best_filling(const BrickCourse& course, int number, const LaidBricks& laid, const BrickBox& box) {
    const Grid<int> below = bricks_below(course, number, laid);
    Filled best;
    for (const Bond& bond : bonds(number)) {
        Filled next;
        next.entries = box.of(course.kind);
        CourseFiller filler(course, course.cells);
        filler.fill(next.entries, bond);
        next.unfilled = filler.unfilled();
        next.cost = 1000.0 * next.unfilled + static_cast<double>(filler.bricks().size()) +
                    0.25 * aligned_joints(course, filler.bricks(), below);
        next.bricks = filler.bricks();
        if (next.cost < best.cost) best = std::move(next);
    }
    return best;
}

Error cannot_fill(const BrickShape& shape, const BrickCourse& course, int unfilled, const BrickBox& box) {
    const Message where = say(
        "bricks.where",
        {{"studs", unfilled}, {"half", half_of(shape.half)}, {"mm", number(course.bottom * kPlateHeight)}});
    if (course.unsupported > 0) return {ErrorKind::usage, say("bricks.cannot_span", {{"where", where}})};
    if (box.limited()) return {ErrorKind::usage, say("bricks.stock_too_small", {{"where", where}})};
    return {ErrorKind::usage, say("bricks.too_narrow", {{"where", where}})};
}

}  // namespace

BrickBox::BrickBox(const BrickOptions& options) {
    const auto chosen = [&options](const BrickPart& part) {
        return options.family.empty() ||
               std::any_of(options.family.begin(), options.family.end(), [&](const std::string& size) {
                   return brick_size(size) == BrickSize{part.width, part.length};
               });
    };
    for (const BrickPart& part : brick_parts()) {
        if (!chosen(part)) continue;
        Entry entry{&part, kEnough};
        for (const BrickStock& stock : options.stock) {
            if (brick_size(stock.size) != BrickSize{part.width, part.length}) continue;
            entry.left = stock.pieces;
            limited_ = true;
        }
        of(part.kind).push_back(entry);
    }
}

void BrickBox::put_back(const Brick& brick) {
    const int width = std::min(brick.rows, brick.columns), length = std::max(brick.rows, brick.columns);
    for (Entry& entry : of(brick.kind))
        if (entry.part->width == width && entry.part->length == length) ++entry.left;
}

Result<BrickLayout> brick_layout(const BrickShape& shape, BrickRim rim, BrickBox& box) {
    if (shape.studs() > kMostStuds)
        return fail(ErrorKind::usage,
                    say("bricks.too_many", {{"half", half_of(shape.half)}, {"studs", shape.studs()}}));
    const std::vector<BrickCourse> courses = brick_courses(shape, rim);
    LaidBricks laid(courses);
    for (int number = 0; number < static_cast<int>(courses.size()); ++number) {
        const BrickCourse& course = courses[static_cast<std::size_t>(number)];
        Filled filled = best_filling(course, number, laid, box);
        if (filled.unfilled > 0) return tl::unexpected(cannot_fill(shape, course, filled.unfilled, box));
        box.of(course.kind) = std::move(filled.entries);
        for (const Brick& brick : filled.bricks) laid.add(number, brick);
    }
    BrickLayout layout;
    layout.pieces_at_first = laid.pieces().second;
    layout.pieces = join_pieces(courses, laid, box);
    layout.build = {shape.half, shape.rows(), shape.columns(), laid.in_order()};
    return layout;
}

}  // namespace snug
