#include "snug/mesh/shell.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace snug {
namespace {

constexpr std::size_t kWord = 64;
/// Empty cubes around all others: room for the neighbours and for the surface around those.
constexpr int kMargin = 2;
constexpr std::uint32_t kNoCorner = 0xffff'ffff;

/// A grid of bits, rows of whole words along k.
struct Bits {
    std::size_t ni = 0, nj = 0, words = 0;
    std::vector<std::uint64_t> word;

    [[nodiscard]] const std::uint64_t* row(std::size_t i, std::size_t j) const {
        return word.data() + (i * nj + j) * words;
    }
    [[nodiscard]] std::uint64_t* row(std::size_t i, std::size_t j) {
        return word.data() + (i * nj + j) * words;
    }
};

bool bit(const std::uint64_t* row, std::size_t k) {
    return (row[k / kWord] >> k % kWord & 1) != 0;
}

void widen_rows(Bits& bits) {
    for (std::size_t begin = 0; begin < bits.word.size(); begin += bits.words) {
        std::uint64_t before = 0;  // of this row, as it was
        for (std::size_t w = begin; w < begin + bits.words; ++w) {
            const std::uint64_t here = bits.word[w];
            const std::uint64_t next = w + 1 < begin + bits.words ? bits.word[w + 1] : 0;
            bits.word[w] = here | here << 1 | here >> 1 | before >> (kWord - 1) | next << (kWord - 1);
            before = here;
        }
    }
}

/// Or with what lies `stride` words before and behind; rows at the ends are empty anyway.
void widen_across(Bits& bits, std::size_t stride) {
    const std::vector<std::uint64_t> was = bits.word;
    for (std::size_t w = stride; w + stride < was.size(); ++w)
        bits.word[w] = was[w - stride] | was[w] | was[w + stride];
}

/// The net around a solid of lattice points (bits), in lattice coordinates.
class Net {
  public:
    explicit Net(const Bits& inside)
        : inside_(inside),
          nk_(inside.words * kWord),
          below_(inside.nj * nk_, kNoCorner),
          here_(inside.nj * nk_, kNoCorner) {}

    Mesh take() && {
        for (std::size_t i = 0; i + 1 < inside_.ni; ++i) {
            std::swap(below_, here_);
            std::fill(here_.begin(), here_.end(), kNoCorner);
            for (std::size_t j = 0; j + 1 < inside_.nj; ++j) add_row(i, j);
        }
        return std::move(mesh_);
    }

  private:
    /// Cubes between eight lattice points, from (i, j, k) on.
    void add_row(std::size_t i, std::size_t j) {
        const std::array<const std::uint64_t*, 4> rows = {inside_.row(i, j), inside_.row(i, j + 1),
                                                          inside_.row(i + 1, j), inside_.row(i + 1, j + 1)};
        for (std::size_t w = 0; w < inside_.words; ++w) {
            std::uint64_t some = 0, all = ~std::uint64_t{0};
            for (const std::uint64_t* row : rows) {
                some |= row[w];
                all &= row[w];
                // The next word's first point closes this word's last cube.
                const bool next = w + 1 < inside_.words && (row[w + 1] & 1) != 0;
                if (next) some |= 1;
                if (!next) all = 0;
            }
            if (some == 0 || all == ~std::uint64_t{0}) continue;
            for (std::size_t k = w * kWord; k < (w + 1) * kWord && k + 1 < nk_; ++k) add_cube(i, j, k, rows);
        }
    }

    void add_cube(std::size_t i, std::size_t j, std::size_t k,
                  const std::array<const std::uint64_t*, 4>& rows) {
        std::array<bool, 8> in;  // bit 2: i, bit 1: j, bit 0: k
        for (std::size_t c = 0; c < 8; ++c) in[c] = bit(rows[c >> 1], k + (c & 1));
        if (std::all_of(in.begin(), in.end(), [&](bool each) { return each == in[0]; })) return;
        here_[j * nk_ + k] = static_cast<std::uint32_t>(mesh_.vertices.size());
        const Vec3d corner{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
        mesh_.vertices.push_back(vec_cast<float>(corner + middle_of_crossings(in)));
        add_quads(j, k, in);
    }

    static Vec3d middle_of_crossings(const std::array<bool, 8>& in) {
        Vec3d sum;
        double count = 0;
        for (std::size_t c = 0; c < 8; ++c)
            for (const std::size_t axis : {1u, 2u, 4u}) {
                if ((c & axis) != 0 || in[c] == in[c | axis]) continue;
                const auto at = [&](std::size_t of) { return axis == of ? 0.5 : (c & of) != 0 ? 1.0 : 0.0; };
                sum = sum + Vec3d{at(4), at(2), at(1)};
                ++count;
            }
        return sum * (1 / count);
    }

    /// Those around the three lattice edges from this cube's first corner: all four cubes around each have
    /// their vertices by now.
    void add_quads(std::size_t j, std::size_t k, const std::array<bool, 8>& in) {
        const auto here = [&](std::size_t dj, std::size_t dk) { return here_[(j - dj) * nk_ + k - dk]; };
        const auto below = [&](std::size_t dj, std::size_t dk) { return below_[(j - dj) * nk_ + k - dk]; };
        if (in[0] != in[4]) add_quad({here(1, 1), here(0, 1), here(0, 0), here(1, 0)}, in[0]);
        if (in[0] != in[2]) add_quad({below(0, 1), below(0, 0), here(0, 0), here(0, 1)}, in[0]);
        if (in[0] != in[1]) add_quad({below(1, 0), here(1, 0), here(0, 0), below(0, 0)}, in[0]);
    }

    void add_quad(std::array<std::uint32_t, 4> q, bool inside_first) {
        if (!inside_first) std::swap(q[1], q[3]);
        mesh_.triangles.push_back({q[0], q[1], q[2]});
        mesh_.triangles.push_back({q[0], q[2], q[3]});
    }

    const Bits& inside_;
    std::size_t nk_;
    std::vector<std::uint32_t> below_, here_;  // the vertex of each cube of two layers
    Mesh mesh_;
};

}  // namespace

MetCubes::MetCubes(const Box3d& box, int most) {
    side_ = box.longest_side() > 0 ? box.longest_side() / most : 1;
    start_ = box.min;
    cubes_per_mm_ = 1 / side_;
    const auto cubes = [this](double length) {
        return static_cast<int>(std::floor(length / side_)) + 1 + 2 * kMargin;
    };
    const Vec3d size = box.size();
    count_ = {cubes(size.x), cubes(size.y), cubes(size.z)};
    words_ = (static_cast<std::size_t>(count_.k) + kWord - 1) / kWord;
    marked_ = std::vector<std::atomic<std::uint64_t>>(static_cast<std::size_t>(count_.i) *
                                                      static_cast<std::size_t>(count_.j) * words_);
}

MetCubes::Cell MetCubes::cell_of(Vec3d p) const {
    const auto one = [this](double from_start, int count) {
        // Within the margin, whatever rounding makes of the box's own bounds.
        const int cell = static_cast<int>(std::max(from_start, 0.0) * cubes_per_mm_);
        return kMargin + std::min(cell, count - 1 - 2 * kMargin);
    };
    const Vec3d d = p - start_;
    return {one(d.x, count_.i), one(d.y, count_.j), one(d.z, count_.k)};
}

void MetCubes::mark(Cell first, Cell last) {
    for (int i = first.i; i <= last.i; ++i)
        for (int j = first.j; j <= last.j; ++j)
            for (int k = first.k; k <= last.k; ++k) {
                const auto at = static_cast<std::size_t>(k);
                std::atomic<std::uint64_t>& word =
                    marked_[(static_cast<std::size_t>(i) * static_cast<std::size_t>(count_.j) +
                             static_cast<std::size_t>(j)) *
                                words_ +
                            at / kWord];
                const std::uint64_t mask = std::uint64_t{1} << at % kWord;
                // Most are marked already, and looking is cheaper than writing.
                if ((word.load(std::memory_order_relaxed) & mask) == 0)
                    word.fetch_or(mask, std::memory_order_relaxed);
            }
}

void MetCubes::mark(const Box3d& box) {
    mark(cell_of(box.min), cell_of(box.max));
}

bool MetCubes::mark_if_small(const Box3d& box) {
    const Cell first = cell_of(box.min), last = cell_of(box.max);
    if (last.i - first.i > 1 || last.j - first.j > 1 || last.k - first.k > 1) return false;
    mark(first, last);
    return true;
}

void MetCubes::mark(const std::array<Vec3d, 3>& corners) {
    Box3d box;
    for (const Vec3d& corner : corners) box.include(corner);
    if (mark_if_small(box)) return;
    // In two at the middle of the longest edge.
    std::size_t longest = 0;
    double square = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d edge = corners[(i + 1) % 3] - corners[i];
        if (dot(edge, edge) <= square) continue;
        square = dot(edge, edge);
        longest = i;
    }
    const Vec3d p = corners[longest], q = corners[(longest + 1) % 3], r = corners[(longest + 2) % 3];
    const Vec3d middle = (p + q) * 0.5;
    mark({p, middle, r});
    mark({middle, q, r});
}

Mesh MetCubes::shell() const {
    Bits bits{static_cast<std::size_t>(count_.i), static_cast<std::size_t>(count_.j), words_, {}};
    bits.word.reserve(marked_.size());
    for (const auto& word : marked_) bits.word.push_back(word.load(std::memory_order_relaxed));
    widen_rows(bits);
    widen_across(bits, words_);
    widen_across(bits, words_ * bits.nj);
    Mesh mesh = Net(bits).take();
    for (Vec3f& v : mesh.vertices) {
        const Vec3d cubes = vec_cast<double>(v) + Vec3d{0.5 - kMargin, 0.5 - kMargin, 0.5 - kMargin};
        v = vec_cast<float>(start_ + cubes * side_);
    }
    return mesh;
}

}  // namespace snug
