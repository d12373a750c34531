#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "snug/base/result.h"
#include "snug/search/arrange.h"
#include "snug/search/arranged_items.h"
#include "snug/search/arranging.h"
#include "snug/search/given_room.h"
#include "snug/search/mask_rooms.h"
#include "snug/space/space_for.h"

namespace snug {

/// What a space of so many blocks costs, by the design's goal: less is better.
[[nodiscard]] long long space_price(Vec3i blocks, const Design& design, Vec3d block_mm);

/// One arrangement: what arrange.h promises, step by step.
class Arranger {
  public:
    struct Found {
        MaskLayout layout;
        std::vector<int> heights;
        MaskRoom room;
        std::vector<LayerLevels> levels;
        DesignSpace space;
        BlockWalls walls;
    };

    Arranger(std::span<Object> objects, const Design& design, std::vector<bool> locked, long long work,
             const ArrangeWatch& watch)
        : objects_(objects), design_(design), locked_(std::move(locked)), work_(work), watch_(watch) {}

    /// Spaces of more blocks along y or z do not count, where none is given.
    void keep_below(Vec3i blocks) { most_ = blocks; }
    /// Looks for it, and writes it into the design that it was made of. `explain`: where it does not fit, who
    /// is left out, and what would do.
    [[nodiscard]] Result<Arrangement> run(Design& design, bool explain);

  private:
    [[nodiscard]] bool given() const { return has_given_space(design_); }
    [[nodiscard]] Result<Found> in_free_space();
    [[nodiscard]] Result<Found> around_locked();
    /// That could hold all, the least price first.
    [[nodiscard]] std::vector<Vec3i> spaces_around_locked(const std::vector<int>& heights) const;
    [[nodiscard]] Result<Found> in_space(const PackedSpace& space, bool explain);
    [[nodiscard]] std::optional<Found> in_room(const ItemMasks& masks, const GivenRoom& given,
                                               MaskPacker& packer, long long until);
    [[nodiscard]] Error does_not_fit(const ItemMasks& masks, const GivenRoom& given);
    [[nodiscard]] std::vector<Message> what_holds_all(Vec3i given_blocks);
    /// For the explanation alone, which is no longer asked whether to go on.
    [[nodiscard]] long long explaining_work() const {
        return std::min(work_, usual_arranging_work(design_)) / 8;
    }
    [[nodiscard]] std::vector<std::vector<int>> all_heights(int most) const;
    [[nodiscard]] RoomTask task_for(const std::vector<int>& heights) const;
    [[nodiscard]] Found found_in_room(const PackedMasks& packed, const std::vector<int>& heights) const;
    [[nodiscard]] std::optional<long long> least_blocks() const;
    void settle(const ItemMasks& masks, Found& found, MaskPacker& packer);
    void refine(const ItemMasks& masks, Found& found, MaskPacker& packer, long long most_work) const;
    void finish(const ItemMasks& masks, Found& found) const;
    void take_least_shock(const ItemMasks& masks, const Found& refined, Found& found, MaskPacker& packer);
    void put_heaviest_low(const ItemMasks& masks, Found& found) const;
    void centre_layers(const ItemMasks& masks, Found& found) const;
    [[nodiscard]] Design written(const ItemMasks& masks, const Found& found) const;
    [[nodiscard]] PackingWatch packing_watch();
    void tell(const ItemMasks& masks, const Found& found);

    std::span<Object> objects_;
    const Design& design_;
    std::vector<bool> locked_;
    long long work_, done_ = 0;
    const ArrangeWatch& watch_;
    std::optional<ItemMasks> masks_;
    std::optional<double> best_mm3_;
    std::optional<Vec3i> like_;  ///< a space that is to grow as little as may be along y and z, for advice
    Vec3i most_{kMostBlocks, kMostBlocks, kMostBlocks};
    bool cancelled_ = false;
};

}  // namespace snug
