#include "snug/fabricate/bricks/brick_statics_report.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "snug/base/text.h"

namespace snug {
namespace {

std::string half_name(Half half) {
    return half == Half::lower ? "lower half" : "lid";
}

/// "when it is lifted by its rim"
std::string when(BrickLoad load) {
    switch (load) {
        case BrickLoad::lifted:
            return "when it is lifted by its rim";
        case BrickLoad::turned:
            return "when it lies on its rim, cavity down";
        case BrickLoad::standing:
            break;
    }
    return "as it stands on the table";
}

std::string load_label(BrickLoad load) {
    switch (load) {
        case BrickLoad::lifted:
            return "lifted by its rim";
        case BrickLoad::turned:
            return "cavity down on its rim";
        case BrickLoad::standing:
            break;
    }
    return "standing";
}

std::string percent(double share) {
    return share > 0 && share < 0.01 ? "less than 1 %" : number(share * 100, 0) + " %";
}

std::string outcome_text(const BrickStrength& strength) {
    switch (strength.outcome) {
        case StrengthOutcome::holds:
            if (strength.used == 0) return "holds without any grip";
            return std::string("holds, with ") + (strength.exact || strength.used < 0.01 ? "" : "at most ") +
                   percent(strength.used) + " of the studs' grip";
        case StrengthOutcome::overloaded:
            return "asks for " + percent(strength.used) + " of the studs' grip";
        case StrengthOutcome::loose:
            return counted(strength.loose.size(), "brick falls", "bricks fall") + " out";
        case StrengthOutcome::falls:
            return "tips over or falls apart";
        case StrengthOutcome::no_solver:
        case StrengthOutcome::too_large:
        case StrengthOutcome::unsolved:
            break;
    }
    return "not checked";
}

/// "2x4 brick"
std::string piece_name(const Brick& brick) {
    const char* kind = brick.kind == BrickKind::tile    ? " tile"
                       : brick.kind == BrickKind::plate ? " plate"
                                                        : " brick";
    return std::to_string(std::min(brick.rows, brick.columns)) + "x" +
           std::to_string(std::max(brick.rows, brick.columns)) + kind;
}

/// Where one looks for a stud, as the build pages show the half: seen from above, the far left first.
std::string stud_place(int row, int column, int plates) {
    return number(plates * kPlateHeight, 1) + " mm above the half's floor, stud " +
           std::to_string(column + 1) + " from the left in row " + std::to_string(row + 1) +
           " from the far side";
}

/// What is wrong, or was not done, as a sentence; none where the half holds.
std::optional<Finding> finding_of(const BrickBuild& build, const DesignSpace& space,
                                  const BrickStrength& strength) {
    const std::string who = "the " + half_name(build.half), how = when(strength.load);
    switch (strength.outcome) {
        case StrengthOutcome::holds:
            return {};
        case StrengthOutcome::overloaded: {
            const BrickJoint& joint = *strength.weakest;
            const Brick &lower = build.bricks[joint.lower], &upper = build.bricks[joint.upper];
            return Finding{Severity::warning, "bricks_overloaded",
                           who + " comes apart " + how + ": its studs would have to hold " +
                               percent(strength.used) + " of what they can. It gives first between a " +
                               piece_name(lower) + " and the " + piece_name(upper) + " on it, " +
                               stud_place(joint.row, joint.column, upper.bottom) +
                               ". Make floor and walls thicker, allow longer bricks, or glue that joint",
                           design_place(build, space, joint.row + 0.5 * joint.rows,
                                        joint.column + 0.5 * joint.columns, upper.bottom)};
        }
        case StrengthOutcome::loose: {
            const Brick& first = build.bricks[strength.loose.front()];
            return Finding{Severity::warning, "bricks_loose",
                           counted(strength.loose.size(), "brick", "bricks") + " of " + who + " " +
                               (strength.loose.size() == 1 ? "falls" : "fall") + " out " + how +
                               ", tied to nothing that is held: the first is a " + piece_name(first) + ", " +
                               stud_place(first.row, first.column, first.bottom) +
                               ". Glue them, or take a design whose floor and walls are at least two layers",
                           design_place(build, space, first.row + 0.5 * first.rows,
                                        first.column + 0.5 * first.columns, first.bottom)};
        }
        case StrengthOutcome::falls:
            return Finding{Severity::warning,
                           "bricks_fall",
                           who + " tips over or falls apart " + how +
                               ", whatever the studs hold: support it by hand, or make its rim level",
                           {}};
        case StrengthOutcome::no_solver:
            return Finding{Severity::note,
                           "bricks_unchecked",
                           "how firmly " + who + " holds " + how +
                               " was not checked, since that takes a solver which is not here: "
                               "`snug make --for bricks` on a computer has one",
                           {}};
        case StrengthOutcome::too_large:
            return Finding{Severity::note,
                           "bricks_unchecked",
                           "how firmly " + who + " holds " + how + " was not checked: for its " +
                               grouped(build.bricks.size()) +
                               " bricks that would take too long. Lift it with both hands below",
                           {}};
        case StrengthOutcome::unsolved:
            return Finding{Severity::note,
                           "bricks_unchecked",
                           "how firmly " + who + " holds " + how + " is not known: the check found no answer",
                           {}};
    }
    return {};
}

}  // namespace

void tell_statics(const BrickBuild& build, const DesignSpace& space, const BrickStatics& statics,
                  WorkshopPack& pack) {
    if (build.bricks.empty()) return;
    for (const BrickStrength& strength : statics) {
        const char* half = build.half == Half::lower ? "Lower half, " : "Lid, ";
        pack.figures.push_back({half + load_label(strength.load), outcome_text(strength)});
        if (auto finding = finding_of(build, space, strength)) pack.findings.push_back(std::move(*finding));
    }
}

Vec3d design_place(const BrickBuild& build, const DesignSpace& space, double row, double column,
                   double plates) {
    // The lower foam is seen from +x with -y at the far side, the lid from -x with +y there.
    const Vec3d half{0.5 * space.blocks.x * space.block_mm.x, 0.5 * space.blocks.y * space.block_mm.y,
                     0.5 * space.blocks.z * space.block_mm.z};
    const double up = plates * kPlateHeight, down = row * kBrickPitch;
    const bool lower = build.half == Half::lower;
    return {lower ? up - half.x : half.x - up, lower ? down - half.y : half.y - down,
            column * kBrickPitch - half.z};
}

}  // namespace snug
