#include "snug/check/largest_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

namespace snug {
namespace {

/// A cube that may hold the centre of a larger ball.
struct Cell {
    Vec3d centre;
    double half = 0;   ///< half its side
    double bound = 0;  ///< no ball centred in it is larger
    GapSpace::Surroundings surroundings;
    int order = 0;
};

struct LessPromising {
    bool operator()(const Cell& a, const Cell& b) const {
        return a.bound < b.bound || (a.bound == b.bound && a.order > b.order);
    }
};

const double kHalfDiagonal = std::sqrt(3.0);  ///< of a cube whose side is 2

/// The greatest distance that a point of the cube can have from the nearer of two points, or more. The nearer
/// distance squared is at most any weighted mean of both, which is a paraboloid around the weighted mean
/// point: where the two lie on opposite sides, it grows with the square of the cube's size only.
double farthest_from_both(Vec3d centre, double half, Vec3d p, Vec3d q) {
    const Vec3d apart = q - p;
    double least = std::numeric_limits<double>::infinity();
    constexpr int kSteps = 8;
    for (int i = 0; i <= kSteps; ++i) {
        const double weight = static_cast<double>(i) / kSteps;
        const Vec3d from_mean = centre - (p + apart * weight);
        const Vec3d corner{std::fabs(from_mean.x) + half, std::fabs(from_mean.y) + half,
                           std::fabs(from_mean.z) + half};
        least = std::min(least, dot(corner, corner) + weight * (1 - weight) * dot(apart, apart));
    }
    return std::sqrt(least);
}

class Search {
  public:
    Search(const GapSpace& gap, const LargestBallOptions& options, const Progress& progress)
        : gap_(gap), options_(options), progress_(progress) {}

    bool run(const Box3d& bounds) {
        consider(
            {bounds.centre(), bounds.longest_side() / 2, std::numeric_limits<double>::infinity(), {}, 0});
        while (!cells_.empty() && !cancelled_ && !exhausted()) {
            const Cell cell = cells_.top();
            if (cell.bound <= threshold()) break;
            cells_.pop();
            const double half = cell.half / 2;
            for (int child = 0; child < 8; ++child) {
                const Vec3d way{child & 4 ? half : -half, child & 2 ? half : -half, child & 1 ? half : -half};
                consider({cell.centre + way, half, cell.bound, cell.surroundings, 0});
            }
        }
        return !cancelled_;
    }

    [[nodiscard]] LargestBall result() const {
        LargestBall result = best_;
        const double possible = std::max(dropped_, cells_.empty() ? 0 : cells_.top().bound);
        result.radius_error = std::max(possible - best_.radius, 0.0);
        return result;
    }

  private:
    static constexpr std::uint64_t kWorkBetweenQuestions = 1 << 20;

    [[nodiscard]] double threshold() const {
        return best_.radius + std::max(options_.relative_error * best_.radius, options_.absolute_error);
    }

    [[nodiscard]] bool exhausted() const {
        return probes_ >= options_.most_probes || work_ >= options_.most_work;
    }

    GapSpace::Probe probe(Vec3d p, double radius, double enough, const GapSpace::Surroundings& known) {
        ++probes_;
        if ((probes_ % 1024 == 0 || work_ >= next_question_) && !cancelled_) {
            const double spent =
                std::max(static_cast<double>(probes_) / options_.most_probes,
                         static_cast<double>(work_) / static_cast<double>(options_.most_work));
            cancelled_ = !go_on(progress_, std::min(spent, 1.0));
            next_question_ = work_ + kWorkBetweenQuestions;
        }
        const GapSpace::Probe probed = gap_.probe(p, radius, enough, known);
        work_ += probed.work;
        return probed;
    }

    /// Probes a cell's centre, keeps the ball found there, and keeps the cell if it may hold a larger one.
    void consider(Cell cell) {
        const double radius = cell.half * kHalfDiagonal;
        const double limit = threshold();
        const double enough = std::min(limit - radius, best_.radius);
        const GapSpace::Probe probed = probe(cell.centre, radius, enough, cell.surroundings);
        if (probed.room > best_.radius) {
            best_ = {cell.centre, probed.room, 0};
            climb(cell.half, probed.surroundings);
        }
        cell.bound = std::min(cell.bound, greatest_room(probed, cell.centre, cell.half));
        if (cell.bound <= limit) {
            dropped_ = std::max(dropped_, cell.bound);
            return;
        }
        cell.surroundings = probed.surroundings;
        cell.order = cells_made_++;
        cells_.push(cell);
    }

    /// From a new best ball uphill: the bounds close in much faster than the centres of cells come upon a
    /// peak.
    void climb(double step, GapSpace::Surroundings known) {
        constexpr int kMostProbes = 500;
        const int last = probes_ + kMostProbes;
        const double least = std::max(options_.absolute_error, options_.relative_error * best_.radius) / 16;
        while (step > least && probes_ < last && !cancelled_ && work_ < options_.most_work) {
            bool higher = false;
            for (int direction = 0; direction < 27 && !higher; ++direction) {
                const Vec3d way{direction / 9 - 1.0, direction / 3 % 3 - 1.0, direction % 3 - 1.0};
                const Vec3d p = best_.centre + way * step;
                const GapSpace::Probe probed = probe(p, 0, best_.radius, known);
                if (probed.room <= best_.radius) continue;
                best_ = {p, probed.room, 0};
                known = probed.surroundings;
                higher = true;
            }
            if (!higher) step /= 2;
        }
    }

    const GapSpace& gap_;
    const LargestBallOptions& options_;
    const Progress& progress_;
    LargestBall best_;
    double dropped_ = 0;  ///< the greatest bound of a cell that was given up
    std::priority_queue<Cell, std::vector<Cell>, LessPromising> cells_;
    int cells_made_ = 0;
    int probes_ = 0;
    std::uint64_t work_ = 0;
    std::uint64_t next_question_ = kWorkBetweenQuestions;  ///< whether to go on, in work
    bool cancelled_ = false;
};

}  // namespace

double greatest_room(const GapSpace::Probe& probe, Vec3d centre, double half) {
    double bound = probe.room + half * kHalfDiagonal;
    for (int i = 0; i < probe.obstacle_count; ++i) {
        for (int other = i + 1; other < probe.obstacle_count; ++other) {
            bound =
                std::min(bound, farthest_from_both(centre, half, probe.obstacles[static_cast<std::size_t>(i)],
                                                   probe.obstacles[static_cast<std::size_t>(other)]));
        }
    }
    return bound;
}

Result<LargestBall> largest_ball(const GapSpace& gap, const Box3d& bounds, const LargestBallOptions& options,
                                 const Progress& progress) {
    if (bounds.empty()) return LargestBall{};
    Search search(gap, options, progress);
    if (!search.run(bounds)) return fail(ErrorKind::cancelled, say("cancelled"));
    return search.result();
}

}  // namespace snug
