#include "cli/clp_solver.h"

#include <algorithm>

// Headers of others, with warnings of their own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>
#pragma GCC diagnostic pop

namespace snug {
namespace {

constexpr int kIterationsBetweenLooks = 64;

/// What CLP's `status` says.
enum ClpStatus { kOptimal = 0, kInfeasible = 1, kStoppedByHandler = 5 };

/// What the listener has told and heard. CLP works with copies of the listener, so it lies outside.
struct Talk {
    const Progress& progress;
    int rows;
    double told = 0;
    bool cancelled = false;
};

/// Asks the progress whether to go on.
class Listener : public ClpEventHandler {
  public:
    explicit Listener(Talk& talk) : talk_(&talk) {}

    int event(Event what) override {
        constexpr int kGoOn = -1, kStop = kStoppedByHandler;
        if (what != endOfIteration) return kGoOn;
        const int iterations = model_->numberIterations();
        if (iterations % kIterationsBetweenLooks != 0) return kGoOn;
        // As many iterations as there are rows are half of the way; cleaning up begins again at none.
        talk_->told =
            std::max(talk_->told, static_cast<double>(iterations) / (iterations + std::max(talk_->rows, 1)));
        if (go_on(talk_->progress, talk_->told)) return kGoOn;
        talk_->cancelled = true;
        return kStop;
    }
    [[nodiscard]] ClpEventHandler* clone() const override { return new Listener(*this); }

  private:
    Talk* talk_;
};

Result<LpSolution> solve(const LinearProgram& program, const Progress& progress) {
    ClpSimplex model;
    model.setLogLevel(0);
    model.loadProblem(program.columns(), program.rows(), program.first.data(), program.row.data(),
                      program.value.data(), program.lower.data(), program.upper.data(), program.cost.data(),
                      program.row_lower.data(), program.row_upper.data());
    Talk talk{progress, program.rows()};
    Listener listener(talk);
    model.passInEventHandler(&listener);
    // Nearly all costs are 0, which leaves the dual simplex without guidance: it takes several times as long.
    ClpSolve how;
    how.setSolveType(ClpSolve::usePrimal);
    model.initialSolve(how);
    if (!talk.cancelled && model.status() != kOptimal && model.status() != kInfeasible) model.dual();
    if (talk.cancelled) return fail(ErrorKind::cancelled, say("cancelled.nothing_written"));
    if (model.status() != kOptimal && model.status() != kInfeasible)
        return fail(ErrorKind::usage, say("clp.no_solution"));
    LpSolution solution;
    solution.feasible = model.status() == kOptimal;
    if (!solution.feasible) return solution;
    solution.x.assign(model.primalColumnSolution(), model.primalColumnSolution() + program.columns());
    solution.price.assign(model.dualRowSolution(), model.dualRowSolution() + program.rows());
    return solution;
}

}  // namespace

LpSolver clp_solver() {
    return solve;
}

}  // namespace snug
