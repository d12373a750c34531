#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "snug/base/rotation.h"
#include "snug/base/seeded_numbers.h"
#include "snug/base/vec.h"
#include "snug/design/search_options.h"
#include "snug/space/design_space.h"

// Rotations as unit quaternions: spread evenly, turned a little, and written as the angles that people and
// projects use. No libm: the same bits on every system.

namespace snug {

/// A rotation as a unit quaternion; q and -q are the same rotation.
struct Turn {
    double w = 1, x = 0, y = 0, z = 0;
};

/// First `b`, then `a`.
[[nodiscard]] Turn operator*(const Turn& a, const Turn& b);
[[nodiscard]] Rotation rotation_of(const Turn& turn);
[[nodiscard]] Turn turn_of(const Rotation& rotation);
/// About an axis of any length but 0; the angle in degrees.
[[nodiscard]] Turn turn_about(Vec3d axis, double degrees);
/// The cosine of half the angle between two rotations: 1 where they are equal, 0 half a turn apart.
[[nodiscard]] double closeness(const Turn& a, const Turn& b);

/// The direction of (cosine, sine) in degrees, -180 to 180, the same bits on every system; 0 for (0, 0).
[[nodiscard]] double degrees_of(double sine, double cosine);
/// psi, theta, phi in degrees of R = Rz(phi) Ry(theta) Rx(psi), each rounded to a millionth of a degree.
[[nodiscard]] Vec3d euler_of(const Rotation& rotation);

/// A rotation about an axis of any direction.
[[nodiscard]] Turn small_turn(SeededNumbers& numbers, double degrees);

/// What may be turned with the blocks without changing how many are cut: half turns about the axes, and
/// quarter turns about x where blocks are as wide as deep and as many.
class BlockSymmetry {
  public:
    /// `walls_alike`: without it no two rotations count as equal (walls that differ from side to side).
    /// `upright`: only what keeps +x upward.
    BlockSymmetry(const DesignSpace& space, bool walls_alike, bool upright = false);

    [[nodiscard]] const std::vector<Turn>& turns() const { return turns_; }
    /// The closest that an equal of `a` comes to `b`; see closeness().
    [[nodiscard]] double closest(const Turn& a, const Turn& b) const;
    /// The one among a rotation's equals that turns the object least.
    [[nodiscard]] Turn least_turned(const Turn& turn) const;

  private:
    std::vector<Turn> turns_;
};

/// Rotation number i of an endless sequence that fills all rotations evenly wherever it is broken off
/// (Shoemake, Uniform random rotations, 1992, on a Kronecker sequence); another start for each seed.
[[nodiscard]] Turn spread_turn(std::uint64_t i, std::uint64_t seed);

/// The rotations that a search may use: all, those that keep an axis of the object along +x, or fewer.
class AllowedTurns {
  public:
    explicit AllowedTurns(std::optional<Upright> upright);
    /// As an object is given; turned about +x from there; the same on each face that quarter turns bring
    /// down; or all.
    AllowedTurns(const Turn& given, Turns turns);

    [[nodiscard]] bool all() const { return lays_.empty(); }
    [[nodiscard]] bool only_one() const { return !spins_; }
    [[nodiscard]] bool allows(const Turn& turn) const;
    /// One that is allowed and turns about nothing else.
    [[nodiscard]] Turn plain() const { return all() ? Turn{} : lays_.front(); }
    /// As spread_turn(), among the allowed.
    [[nodiscard]] Turn spread(std::uint64_t i, std::uint64_t seed) const;
    /// As small_turn(): what may come after an allowed turn.
    [[nodiscard]] Turn small(SeededNumbers& numbers, double degrees) const;

  private:
    std::vector<Turn> lays_;  ///< what is turned about +x; empty: all are allowed
    bool spins_ = true;       ///< turned about +x
};

/// What a design's search allows of an object that is given so: where shock is weighed and no axis stays
/// upward by itself, as SearchOptions::turns has it, else all.
[[nodiscard]] AllowedTurns allowed_turns(const SearchOptions& options, Vec3d given_deg);

/// From the way that an object is given onto each of its six faces; as it is first.
[[nodiscard]] const std::array<Turn, 6>& turns_onto_faces();

}  // namespace snug
