#include "snug/solid/corner_fans.h"

namespace snug {
namespace {

constexpr unsigned kArounds = 256, kJoins = 8;

bool filled(unsigned around, int octant) {
    return (around >> octant & 1) != 0;
}

bool is_corner(unsigned around) {
    for (const int bit : kOctantBit) {
        bool same = true;
        for (int octant = 0; octant < 8; ++octant)
            same = same && filled(around, octant) == filled(around, octant ^ bit);
        if (same) return false;
    }
    return true;
}

/// The four blocks around an edge that ends in the point, in turn, and the faces between each and the next.
struct EdgeRing {
    std::array<int, 4> octants, faces;

    EdgeRing(int axis, bool far) {
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        const auto bit = [](int a) { return kOctantBit[static_cast<std::size_t>(a)]; };
        const int first = far ? bit(axis) : 0;
        octants = {first, first | bit(next), first | bit(next) | bit(last), first | bit(last)};
        faces = {octant_face(octants[0], next), octant_face(octants[1], last), octant_face(octants[2], next),
                 octant_face(octants[3], last)};
    }
    /// Foam in two opposite blocks only.
    [[nodiscard]] bool is_crossed(unsigned around) const {
        const bool even = filled(around, octants[0]), odd = filled(around, octants[1]);
        return even != odd && filled(around, octants[2]) == even && filled(around, octants[3]) == odd;
    }
};

/// Edges along x come from above.
bool comes_from_far(int axis) {
    return axis == 0;
}

/// Fans while they are put together: faces with the same label are in one.
class Fans {
  public:
    explicit Fans(unsigned around) : around_(around) {
        for (int face = 0; face < 12; ++face) labels_[static_cast<std::size_t>(face)] = face;
    }

    /// Goes on across an edge from face to face.
    void pass(const EdgeRing& ring, bool joined) {
        const bool crossed = ring.is_crossed(around_);
        int before = -1;
        for (std::size_t i = 0; i < 4; ++i) {
            if (crossed) {
                if (filled(around_, ring.octants[i]) != joined) unite(ring.faces[(i + 3) % 4], ring.faces[i]);
            } else if (filled(around_, ring.octants[i]) != filled(around_, ring.octants[(i + 1) % 4])) {
                if (before >= 0) unite(before, ring.faces[i]);
                before = ring.faces[i];
            }
        }
    }

    /// Numbered in the order of the blocks whose faces they have.
    [[nodiscard]] CornerFans numbered() const {
        CornerFans fans;
        fans.fan.fill(kNoFan);
        for (int octant = 0; octant < 8; ++octant) {
            for (int axis = 0; axis < 3; ++axis) {
                const int across = octant ^ kOctantBit[static_cast<std::size_t>(axis)];
                if (!filled(around_, octant) || filled(around_, across)) continue;
                const auto face = static_cast<std::size_t>(octant_face(octant, axis));
                if (fans.fan[face] != kNoFan) continue;
                for (std::size_t other = 0; other < 12; ++other)
                    if (labels_[other] == labels_[face]) fans.fan[other] = fans.count;
                ++fans.count;
            }
        }
        return fans;
    }

  private:
    void unite(int a, int b) {
        const int kept = labels_[static_cast<std::size_t>(a)], gone = labels_[static_cast<std::size_t>(b)];
        for (int& label : labels_)
            if (label == gone) label = kept;
    }

    unsigned around_;
    std::array<int, 12> labels_{};
};

/// By bits 1 << axis, the edges that leave the point and have foam in two opposite blocks only.
unsigned crossed_edges(unsigned around) {
    unsigned crossed = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (EdgeRing(axis, !comes_from_far(axis)).is_crossed(around)) crossed |= 1u << axis;
    return crossed;
}

CornerFans fans_of(unsigned around, unsigned coming, unsigned leaving) {
    Fans fans(around);
    for (int axis = 0; axis < 3; ++axis) {
        fans.pass(EdgeRing(axis, comes_from_far(axis)), (coming >> axis & 1) != 0);
        fans.pass(EdgeRing(axis, !comes_from_far(axis)), (leaving >> axis & 1) != 0);
    }
    CornerFans found = fans.numbered();
    found.joined = static_cast<std::uint8_t>(leaving);
    return found;
}

CornerFans most_fans(unsigned around, unsigned coming) {
    const unsigned crossed = crossed_edges(around);
    CornerFans best;
    for (unsigned leaving = 0; leaving < kJoins; ++leaving) {
        if ((leaving & ~crossed) != 0) continue;
        const CornerFans found = fans_of(around, coming, leaving);
        if (found.count > best.count) best = found;
    }
    return best;
}

}  // namespace

CornerFanTable::CornerFanTable() {
    fans_.reserve(kArounds * kJoins);
    for (unsigned joined = 0; joined < kJoins; ++joined) {
        for (unsigned around = 0; around < kArounds; ++around) {
            if (is_corner(around)) {
                fans_.push_back(most_fans(around, joined));
            } else {
                fans_.emplace_back();
                fans_.back().joined = static_cast<std::uint8_t>(joined);
            }
        }
    }
}

const CornerFanTable& CornerFanTable::get() {
    static const CornerFanTable table;
    return table;
}

}  // namespace snug
