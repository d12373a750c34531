#include "snug/fabricate/bricks/brick_statics_report.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

/// "when it is lifted by its rim"
Message when(BrickLoad load) {
    switch (load) {
        case BrickLoad::lifted:
            return say("bricks.lifted");
        case BrickLoad::turned:
            return say("bricks.turned");
        case BrickLoad::standing:
            break;
    }
    return say("bricks.standing");
}

/// "Lid, lifted by its rim"
Message load_label(Half half, BrickLoad load) {
    const bool lower = half == Half::lower;
    switch (load) {
        case BrickLoad::lifted:
            return say(lower ? "figure.lower_lifted" : "figure.lid_lifted");
        case BrickLoad::turned:
            return say(lower ? "figure.lower_turned" : "figure.lid_turned");
        case BrickLoad::standing:
            break;
    }
    return say(lower ? "figure.lower_standing" : "figure.lid_standing");
}

Message percent(double share) {
    if (share > 0 && share < 0.01) return say("bricks.below_one_percent");
    return as_it_is(number(share * 100, 0) + " %");
}

Message outcome_text(const BrickStrength& strength) {
    switch (strength.outcome) {
        case StrengthOutcome::holds:
            if (strength.used == 0) return say("figure.holds_by_itself");
            return say(strength.exact || strength.used < 0.01 ? "figure.holds" : "figure.holds_at_most",
                       {{"percent", percent(strength.used)}});
        case StrengthOutcome::overloaded:
            return say("figure.overloaded", {{"percent", percent(strength.used)}});
        case StrengthOutcome::loose:
            return say("figure.loose", {{"bricks", strength.loose.size()}});
        case StrengthOutcome::falls:
            return say("figure.falls");
        case StrengthOutcome::no_solver:
        case StrengthOutcome::too_large:
        case StrengthOutcome::unsolved:
            break;
    }
    return say("figure.not_checked");
}

/// "2x4 brick"
Message piece_name(const Brick& brick) {
    const char* kind = brick.kind == BrickKind::tile    ? "bricks.tile"
                       : brick.kind == BrickKind::plate ? "bricks.plate"
                                                        : "bricks.brick";
    return say(kind, {{"size", std::to_string(std::min(brick.rows, brick.columns)) + "x" +
                                   std::to_string(std::max(brick.rows, brick.columns))}});
}

/// Where one looks for a stud, as the build pages show the half: seen from above, the far left first.
Message stud_place(int row, int column, int plates) {
    return say("bricks.place", {{"mm", number(plates * kPlateHeight, 1)},
                                {"column", std::to_string(column + 1)},
                                {"row", std::to_string(row + 1)}});
}

/// What is wrong, or was not done, as a sentence; none where the half holds.
std::optional<Finding> finding_of(const BrickBuild& build, const DesignSpace& space,
                                  const BrickStrength& strength) {
    const Message half = half_of(build.half), load = when(strength.load);
    switch (strength.outcome) {
        case StrengthOutcome::holds:
            return {};
        case StrengthOutcome::overloaded: {
            const BrickJoint& joint = *strength.weakest;
            const Brick &lower = build.bricks[joint.lower], &upper = build.bricks[joint.upper];
            return Finding{
                Severity::warning,
                say("bricks_overloaded", {{"half", half},
                                          {"load", load},
                                          {"percent", percent(strength.used)},
                                          {"lower", piece_name(lower)},
                                          {"upper", piece_name(upper)},
                                          {"place", stud_place(joint.row, joint.column, upper.bottom)}}),
                design_place(build, space, joint.row + 0.5 * joint.rows, joint.column + 0.5 * joint.columns,
                             upper.bottom)};
        }
        case StrengthOutcome::loose: {
            const Brick& first = build.bricks[strength.loose.front()];
            return Finding{
                Severity::warning,
                say("bricks_loose", {{"bricks", strength.loose.size()},
                                     {"half", half},
                                     {"load", load},
                                     {"first", piece_name(first)},
                                     {"place", stud_place(first.row, first.column, first.bottom)}}),
                design_place(build, space, first.row + 0.5 * first.rows, first.column + 0.5 * first.columns,
                             first.bottom)};
        }
        case StrengthOutcome::falls:
            return Finding{Severity::warning, say("bricks_fall", {{"half", half}, {"load", load}})};
        case StrengthOutcome::no_solver:
            return Finding{Severity::note, say("bricks_unchecked", {{"half", half}, {"load", load}})};
        case StrengthOutcome::too_large:
            return Finding{Severity::note,
                           say("bricks_unchecked/too_large",
                               {{"half", half}, {"load", load}, {"bricks", build.bricks.size()}})};
        case StrengthOutcome::unsolved:
            return Finding{Severity::note,
                           say("bricks_unchecked/unsolved", {{"half", half}, {"load", load}})};
    }
    return {};
}

}  // namespace

void tell_statics(const BrickBuild& build, const DesignSpace& space, const BrickStatics& statics,
                  WorkshopPack& pack) {
    if (build.bricks.empty()) return;
    for (const BrickStrength& strength : statics) {
        pack.figures.push_back({load_label(build.half, strength.load), outcome_text(strength)});
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
