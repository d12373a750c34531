#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "snug/search/arranged_items.h"
#include "snug/search/mask_packer.h"

namespace snug {

/// What a layout costs where its room is settled: what is cut, and then how far its weight lies from the
/// middle, in hundredths of a millimetre along both axes. Asked of one piece after the other, as
/// MaskPacker::refine() does; `layout` is the one that changes meanwhile.
class CutAndBalance {
  public:
    CutAndBalance(const ItemMasks& masks, const MaskRoom& room, const MaskLayout& layout)
        : masks_(masks), layout_(layout), middle_{0, room.rows / 2.0, room.columns / 2.0} {
        for (const double mass : masks.mass) whole_ += mass;
        for (const ItemWay& way : masks.ways) {
            Vec3d sum;
            double count = 0;
            for (const MaskRun& run : runs_of(way.mask)) {
                const int columns = run.end - run.first;
                sum = sum + Vec3d{0, (run.row + 0.5) * columns, (run.first + run.end) * 0.5 * columns};
                count += columns;
            }
            centre_.push_back(sum * (1 / count));
        }
    }
    long long operator()(std::size_t piece, const LaidMask& at) {
        if (piece != others_of_) {
            others_of_ = piece;
            others_ = {};
            for (std::size_t i = 0; i < layout_.size(); ++i)
                if (i != piece) others_ = others_ + moment(i, layout_[i]);
        }
        const Vec3d off = (others_ + moment(piece, at)) * (1 / whole_);
        const double mm = std::fabs(off.y) * masks_.block_mm.y + std::fabs(off.z) * masks_.block_mm.z;
        return masks_.ways[static_cast<std::size_t>(at.shape)].cut_blocks * kCut +
               static_cast<long long>(std::min(mm * 100, kCut - 1.0));
    }

  private:
    static constexpr long long kCut = 10'000'000;
    [[nodiscard]] Vec3d moment(std::size_t i, const LaidMask& at) const {
        const Vec3d place{0, static_cast<double>(at.row), static_cast<double>(at.column)};
        return (place + centre_[static_cast<std::size_t>(at.shape)] - middle_) * masks_.mass[i];
    }
    const ItemMasks& masks_;
    const MaskLayout& layout_;
    Vec3d middle_;
    double whole_ = 0;
    std::vector<Vec3d> centre_;
    std::size_t others_of_ = static_cast<std::size_t>(-1);
    Vec3d others_;
};

}  // namespace snug
