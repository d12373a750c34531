#pragma once

#include <array>
#include <cstdint>
#include <vector>

// How the surface of a solid of blocks passes through a point of their lattice.

namespace snug {

/// The eight blocks around a lattice point are numbered by bits: for each axis the bit of the farther one. By
/// that order the blocks at j = J - 1 come first, among them those at k = K - 1, and of two the lower one.
constexpr std::array<int, 3> kOctantBit{1, 4, 2};

/// The face between block `octant` and the one across from it along `axis`, from 0 to 11.
[[nodiscard]] constexpr int octant_face(int octant, int axis) {
    const int bit = kOctantBit[static_cast<std::size_t>(axis)];
    return axis * 4 + ((octant & (bit - 1)) | (octant >> 1 & ~(bit - 1)));
}

constexpr std::uint8_t kNoFan = 0xff;

/// The faces around a lattice point hang together in closed fans. Along an edge with foam in two opposite
/// blocks only, four faces meet, and the surface goes on from each to one of two others: mostly to that of
/// the same block, else (the edge is `joined`) to that of the other block.
struct CornerFans {
    std::uint8_t count = 0;              ///< each is a vertex; 0 where the point is no true corner
    std::uint8_t joined = 0;             ///< by bits 1 << axis, of the edges that leave the point
    std::array<std::uint8_t, 12> fan{};  ///< of each face, kNoFan where there is none
};

/// Edges come to a point from above (along x) and from lower y and z, and leave it on the other sides. Which
/// of those that leave are joined is chosen so that the fans are most, for then the two passages along each
/// of them lie in two fans: if an edge were passed by one fan twice, the other choice would part it in two.
/// So no two points need more than two edges between them, which differ in a vertex. A point around which the
/// solid looks the same along some axis is no true corner; the edge that runs straight on stays as it is.
class CornerFanTable {
  public:
    /// The table; it is there as long as the program.
    [[nodiscard]] static const CornerFanTable& get();

    /// `around`: a bit 1 << octant for each block that is there. `joined`: the edges that come, as in
    /// CornerFans.
    [[nodiscard]] const CornerFans& operator()(unsigned around, unsigned joined) const {
        return fans_[joined << 8 | around];
    }

  private:
    CornerFanTable();

    std::vector<CornerFans> fans_;
};

}  // namespace snug
