#pragma once

#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/brick_options.h"
#include "snug/fabricate/bricks/brick_build.h"
#include "snug/fabricate/bricks/brick_shape.h"

// Which bricks, and where. Luo et al. (Legolization, 2015) merge at random and mend; a half that stands
// cavity up has foam below all of its foam, so large bricks first with joints that alternate from layer to
// layer give fewer and better bonded ones. Where they fall into pieces, neighbourhoods are laid again (their
// section 4.2) until they are one.

namespace snug {

/// The sizes that may be used, and how many of each there are; shared by the halves.
class BrickBox {
  public:
    explicit BrickBox(const BrickOptions& options);

    struct Entry {
        const BrickPart* part = nullptr;
        long long left = 0;  ///< of pieces; unlimited is more than anyone needs
    };
    /// Of one kind from the largest to the smallest.
    [[nodiscard]] std::vector<Entry>& of(BrickKind kind) { return entries_[static_cast<std::size_t>(kind)]; }
    [[nodiscard]] const std::vector<Entry>& of(BrickKind kind) const {
        return entries_[static_cast<std::size_t>(kind)];
    }
    void put_back(const Brick& brick);
    [[nodiscard]] bool limited() const { return limited_; }

  private:
    std::vector<Entry> entries_[3];
    bool limited_ = false;
};

/// A laid half.
struct BrickLayout {
    BrickBuild build;
    int pieces = 0;           ///< that hold together by studs
    int pieces_at_first = 0;  ///< before anything was laid again
};

/// Lays one half and takes its bricks out of the box. Fails (kind usage) where the sizes cannot fill the
/// foam, where a case's rounded floor leaves foam without support that no size spans, and where the stock
/// does not suffice. With `rim` tiles the tops of BrickShape::rim are tiles.
[[nodiscard]] Result<BrickLayout> brick_layout(const BrickShape& shape, BrickRim rim, BrickBox& box);

}  // namespace snug
