#include "snug/search/turn.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace snug {
namespace {

constexpr double kDegreesPerRadian = 57.295779513082320877;
constexpr double kRootHalf = 0.70710678118654752440;

Turn unit(const Turn& q) {
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {q.w / length, q.x / length, q.y / length, q.z / length};
}

double rounded(double degrees) {
    const double result = std::floor(degrees * 1e6 + 0.5) / 1e6;
    return result == 0 ? 0 : result;
}

double fraction(double value) {
    return value - std::floor(value);
}

}  // namespace

Turn operator*(const Turn& a, const Turn& b) {
    return unit({a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                 a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                 a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w});
}

Rotation rotation_of(const Turn& turn) {
    const auto [w, x, y, z] = turn;
    return {{Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             Vec3d{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             Vec3d{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

Turn turn_of(const Rotation& rotation) {
    const auto& [r0, r1, r2] = rotation.row;
    // The largest of the four is never small, so nothing is divided by almost 0 (Shepperd 1978).
    const std::array<double, 4> square{1 + r0.x + r1.y + r2.z, 1 + r0.x - r1.y - r2.z, 1 - r0.x + r1.y - r2.z,
                                       1 - r0.x - r1.y + r2.z};
    const auto largest = std::max_element(square.begin(), square.end()) - square.begin();
    const double s = square[static_cast<std::size_t>(largest)];
    switch (largest) {
        case 0:
            return unit({s, r2.y - r1.z, r0.z - r2.x, r1.x - r0.y});
        case 1:
            return unit({r2.y - r1.z, s, r1.x + r0.y, r0.z + r2.x});
        case 2:
            return unit({r0.z - r2.x, r1.x + r0.y, s, r2.y + r1.z});
        default:
            return unit({r1.x - r0.y, r0.z + r2.x, r2.y + r1.z, s});
    }
}

Turn turn_about(Vec3d axis, double degrees) {
    const auto [sine, cosine] = sine_cosine_degrees(degrees / 2);
    const double length = std::sqrt(dot(axis, axis));
    return unit({cosine, sine * axis.x / length, sine * axis.y / length, sine * axis.z / length});
}

double closeness(const Turn& a, const Turn& b) {
    return std::fabs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z);
}

double degrees_of(double sine, double cosine) {
    const double length = std::sqrt(sine * sine + cosine * cosine);
    if (!(length > 0)) return 0;
    const double s = sine / length, c = cosine / length;
    // A rough quarter first; then each step turns back by the sine of what is left, which triples the digits.
    double degrees = std::fabs(s) > std::fabs(c) ? (s > 0 ? 90 : -90) : (c > 0 ? 0 : 180);
    for (int step = 0; step < 6; ++step) {
        const auto guess = sine_cosine_degrees(degrees);
        degrees += (s * guess.cosine - c * guess.sine) * kDegreesPerRadian;
    }
    return degrees > 180 ? degrees - 360 : degrees < -180 ? degrees + 360 : degrees;
}

Vec3d euler_of(const Rotation& rotation) {
    const auto& [r0, r1, r2] = rotation.row;
    const double level = std::sqrt(r0.x * r0.x + r1.x * r1.x);
    const double theta = degrees_of(-r2.x, level);
    // Straight up or down x and z turn about one axis: all of it goes to psi.
    if (level < 1e-9) return {rounded(degrees_of(-r1.z, r1.y)), rounded(theta), 0};
    return {rounded(degrees_of(r2.y, r2.z)), rounded(theta), rounded(degrees_of(r1.x, r0.x))};
}

Turn small_turn(SeededNumbers& numbers, double degrees) {
    while (true) {
        const double x = numbers.between(-1, 1), y = numbers.between(-1, 1), z = numbers.between(-1, 1);
        const double square = x * x + y * y + z * z;
        if (square > 1e-4 && square <= 1) return turn_about({x, y, z}, degrees);
    }
}

BlockSymmetry::BlockSymmetry(const DesignSpace& space, bool walls_alike, bool upright) {
    turns_ = {Turn{}};
    if (!walls_alike) return;
    turns_.push_back({0, 1, 0, 0});
    if (!upright) turns_.insert(turns_.end(), {Turn{0, 0, 1, 0}, Turn{0, 0, 0, 1}});
    if (space.block_mm.y != space.block_mm.z || space.blocks.y != space.blocks.z) return;
    const Turn quarter{kRootHalf, kRootHalf, 0, 0};
    const std::vector<Turn> halves = turns_;
    for (const Turn& half : halves) turns_.push_back(quarter * half);
}

double BlockSymmetry::closest(const Turn& a, const Turn& b) const {
    double best = 0;
    for (const Turn& turn : turns_) best = std::max(best, closeness(turn * a, b));
    return best;
}

Turn BlockSymmetry::least_turned(const Turn& turn) const {
    Turn best = turn;
    for (const Turn& equal : turns_) {
        const Turn turned = equal * turn;
        if (std::fabs(turned.w) > std::fabs(best.w) + 1e-12) best = turned;
    }
    return best;
}

Turn spread_turn(std::uint64_t i, std::uint64_t seed) {
    // The powers of the root of x^4 = x + 1: the least regular steps in three dimensions.
    constexpr std::array<double, 3> kStep{0.81917251339616443969, 0.67104360670378920843,
                                          0.54970047790197026694};
    SeededNumbers numbers(seed);
    std::array<double, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        at[axis] = fraction(numbers.unit() + kStep[axis] * static_cast<double>(i));
    const auto a = sine_cosine_degrees(360 * at[1]), b = sine_cosine_degrees(360 * at[2]);
    const double inner = std::sqrt(1 - at[0]), outer = std::sqrt(at[0]);
    return unit({outer * b.cosine, inner * a.sine, inner * a.cosine, outer * b.sine});
}

AllowedTurns::AllowedTurns(std::optional<Upright> upright) {
    if (!upright) return;
    const Vec3d axis = direction(*upright), up{1, 0, 0};
    const Vec3d about = cross(axis, up);
    if (dot(about, about) > 0)
        lays_ = {turn_about(about, 90)};
    else
        lays_ = {axis.x > 0 ? Turn{} : Turn{0, 0, 1, 0}};
}

AllowedTurns::AllowedTurns(const Turn& given, Turns turns) : spins_(turns != Turns::none) {
    if (turns == Turns::any) return;
    for (const Turn& onto : turns_onto_faces())
        if (turns == Turns::quarter || lays_.empty()) lays_.push_back(onto * given);
}

bool AllowedTurns::allows(const Turn& turn) const {
    if (all()) return true;
    const Rotation rotation = rotation_of(turn);
    return std::any_of(lays_.begin(), lays_.end(), [&](const Turn& lay) {
        // The object's own axis that this lays along +x.
        const Vec3d axis = rotation_of(lay).row[0];
        return spins_ ? rotation(axis).x > 1 - 1e-9 : closeness(turn, lay) > 1 - 1e-9;
    });
}

Turn AllowedTurns::spread(std::uint64_t i, std::uint64_t seed) const {
    if (all()) return spread_turn(i, seed);
    const Turn& lay = lays_[static_cast<std::size_t>(i % lays_.size())];
    if (!spins_) return lay;
    constexpr double kGoldenTurn = 0.61803398874989484820;
    SeededNumbers numbers(seed);
    const auto spin = static_cast<double>(i / lays_.size());
    return turn_about({1, 0, 0}, 360 * fraction(numbers.unit() + kGoldenTurn * spin)) * lay;
}

Turn AllowedTurns::small(SeededNumbers& numbers, double degrees) const {
    if (all()) return snug::small_turn(numbers, degrees);
    if (!spins_) return Turn{};
    return turn_about({1, 0, 0}, numbers.unit() < 0.5 ? degrees : -degrees);
}

AllowedTurns allowed_turns(const SearchOptions& options, Vec3d given_deg) {
    if (options.upright || !options.weighs(Objective::shock)) return AllowedTurns(options.upright);
    return {turn_of(rotation_from_euler(given_deg)), options.turns};
}

const std::array<Turn, 6>& turns_onto_faces() {
    static const std::array<Turn, 6> turns{Turn{},
                                           turn_about({0, 1, 0}, 180),
                                           turn_about({0, 1, 0}, 90),
                                           turn_about({0, 1, 0}, -90),
                                           turn_about({0, 0, 1}, 90),
                                           turn_about({0, 0, 1}, -90)};
    return turns;
}

}  // namespace snug
