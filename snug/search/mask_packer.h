#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "snug/base/seeded_numbers.h"
#include "snug/search/mask.h"
#include "snug/search/mask_clash.h"

// Packing of masks: pieces that may be laid in several ways, into rooms of one size, so that no two of them
// take a common column and a gap stays between them. Knows nothing of what the masks are of.
//
// Overlap is made smaller piece by piece: each that clashes goes where it clashes least, of all places in the
// room and all ways to lay it, and where two keep clashing this weighs more and more (guided local search as
// in Umetani and Murakami, Coordinate descent heuristics for the irregular strip packing problem of
// rasterized shapes, 2022, and Gardeyn and others, sparrow, 2025). All places at once are cheap, since how
// deep two shapes lie in each other is known for each place beforehand (mask_clash.h).

namespace snug {

/// One way to lay a piece.
struct MaskShape {
    BitMask mask;          ///< all of its rows and columns must lie in the room, also empty ones
    int height = 0;        ///< that the room must have, in whatever the rooms count
    long long weight = 0;  ///< of layouts that need the same room the least sum of these is best
};

/// Where a piece lies: in which way and which of the rooms, and its first row and column there.
struct LaidMask {
    int shape = 0, bin = 0, row = 0, column = 0;
    friend bool operator==(const LaidMask&, const LaidMask&) = default;
};
using MaskLayout = std::vector<LaidMask>;  ///< of each piece

struct MaskPiece {
    std::vector<int> shapes;         ///< the ways to lay it, one at least
    std::optional<LaidMask> locked;  ///< it stays there
    int group = -1;                  ///< between pieces of one group no gap is kept; -1: of none
    int bin = -1;                    ///< the only room that it may lie in; -1: any
};

struct MaskProblem {
    std::vector<MaskShape> shapes;
    std::vector<MaskPiece> pieces;
    MaskGap gap;
};

/// Rooms of one size.
struct MaskRoom {
    int rows = 0, columns = 0;
    std::vector<int> heights{0};  ///< of each room; shapes that are higher do not go in
    /// Where not all of the rectangle is free: of each shape the first rows and columns where it may not lie.
    /// Empty: it may lie anywhere.
    std::vector<BitMask> refused;
};

/// Asks now and then whether to go on; false cancels. Given what was done, as MaskPacker::work().
using PackingWatch = std::function<bool(long long work)>;

class MaskPacker {
  public:
    MaskPacker(MaskProblem problem, std::uint64_t seed, PackingWatch watch = {});

    [[nodiscard]] const MaskProblem& problem() const { return problem_; }
    /// Places looked at so far: the same for the same questions on every machine.
    [[nodiscard]] long long work() const { return work_; }
    [[nodiscard]] bool cancelled() const { return cancelled_; }
    SeededNumbers& numbers() { return numbers_; }

    /// Whether each piece has some way to be laid in it by itself.
    [[nodiscard]] bool each_fits(const MaskRoom& room);
    /// The pieces one after the other, the largest first, each as far to the first rows as it goes where it
    /// clashes least. `shuffle`: from 0, exactly by size, to 1, in any order. `room` must fit each.
    [[nodiscard]] MaskLayout laid_in_order(const MaskRoom& room, double shuffle);
    /// Shifts every free piece into the room, laid otherwise where it does not go in as it is.
    void bring_inside(const MaskRoom& room, MaskLayout& layout);
    /// Makes room for chance: two pieces change places, or one is laid anywhere.
    void disturb(const MaskRoom& room, MaskLayout& layout);

    /// Lessens the clashes until there are none (true), or until so many rounds in a row found nothing
    /// better, the work is done or it was cancelled: then `layout` is the best of those seen.
    bool separate(const MaskRoom& room, MaskLayout& layout, int idle_rounds, long long most_work);
    /// Of a layout without clashes: each piece in turn is laid where `cost` is least, of all places without a
    /// clash, until none gets better. `cost` is given the piece and its place; less is better.
    using LayoutCost = std::function<long long(std::size_t piece, const LaidMask& at)>;
    void refine(const MaskRoom& room, MaskLayout& layout, const LayoutCost& cost, long long most_work);

    /// How deep two pieces lie in each other; 0: they keep their gap.
    [[nodiscard]] int clash(const MaskLayout& layout, std::size_t a, std::size_t b);
    /// Of one with all others, and whether it lies where the room refuses it; of all.
    [[nodiscard]] long long clashes(const MaskRoom& room, const MaskLayout& layout, std::size_t piece);
    [[nodiscard]] long long clashes(const MaskRoom& room, const MaskLayout& layout);

  private:
    /// The least of what was looked at, and how many there were of equals.
    struct Least {
        LaidMask at;
        std::uint32_t cost = 0xffffffff;
        int equals = 0;
    };

    [[nodiscard]] const ClashMap& clash_map(int fixed, int moved, bool gap);
    [[nodiscard]] bool keep_gap(std::size_t a, std::size_t b) const;
    [[nodiscard]] bool goes_in(const MaskPiece& piece, int shape, int bin, const MaskRoom& room) const;
    /// The cost of every place of one way to lay a piece, or of those a stride apart, into costs_: row by
    /// row, `columns` each.
    struct Places {
        int rows = 0, columns = 0, stride = 1;
        [[nodiscard]] LaidMask at(std::size_t i, int shape, int bin) const {
            const int place = static_cast<int>(i);
            return {shape, bin, place / columns * stride, place % columns * stride};
        }
    };
    Places fill_costs(const MaskRoom& room, const MaskLayout& layout, std::size_t piece, int shape, int bin,
                      const std::vector<char>& present);
    void take_least(Places places, int shape, int bin, Least& least);
    /// From the best of places a stride apart step by step to better ones between them.
    void climb_down(const MaskRoom& room, const MaskLayout& layout, std::size_t piece, Places places,
                    int shape, int bin, Least& least);
    [[nodiscard]] std::uint32_t cost_at(const MaskRoom& room, const MaskLayout& layout, std::size_t piece,
                                        const LaidMask& at, const std::vector<char>& present);
    [[nodiscard]] Least least_clash(const MaskRoom& room, const MaskLayout& layout, std::size_t piece);
    [[nodiscard]] LaidMask lowest_place(const MaskRoom& room, const MaskLayout& layout, std::size_t piece,
                                        const std::vector<char>& present);
    [[nodiscard]] LaidMask anywhere(const MaskRoom& room, std::size_t piece);
    std::uint16_t& weight(std::size_t a, std::size_t b) { return weights_[a * problem_.pieces.size() + b]; }
    void weigh(const MaskLayout& layout);
    [[nodiscard]] bool go_on(long long most_work);

    MaskProblem problem_;
    SeededNumbers numbers_;
    PackingWatch watch_;
    int stride_ = 1;  ///< of the places of large shapes that are looked at first: their clashes change slowly
    std::vector<std::vector<MaskRun>> runs_;  ///< of each shape
    std::vector<long long> size_;             ///< of each piece: the fewest columns of its shapes
    std::vector<std::unique_ptr<ClashMap>> maps_;
    std::vector<std::uint16_t> weights_;  ///< of each pair's clash
    std::vector<std::uint32_t> costs_;
    std::vector<char> all_;  ///< every piece is present
    long long work_ = 0, asked_at_ = 0;
    bool cancelled_ = false;
};

}  // namespace snug
