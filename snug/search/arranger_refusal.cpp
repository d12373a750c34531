#include <algorithm>
#include <cstddef>
#include <utility>

#include "snug/base/text.h"
#include "snug/search/arranger.h"

// What a person is told where a given space does not hold all items.

namespace snug {

/// The most that go in together: those that clash most are left out, one after the other.
Error Arranger::does_not_fit(const ItemMasks& masks, const GivenRoom& given) {
    std::vector<std::size_t> in;
    std::vector<Message> left;
    const auto leave_out = [&](std::size_t at) {
        left.push_back(as_it_is(masks.items[in[at]].name));
        in.erase(in.begin() + static_cast<std::ptrdiff_t>(at));
    };
    for (std::size_t i = 0; i < masks.items.size(); ++i) in.push_back(i);
    bool fit = false;
    while (!in.empty() && !fit) {
        MaskProblem some{masks.problem.shapes, {}, masks.problem.gap};
        for (const std::size_t i : in) some.pieces.push_back(masks.problem.pieces[i]);
        std::size_t alone = in.size();
        for (std::size_t i = 0; i < in.size(); ++i) {
            MaskPacker one({masks.problem.shapes, {some.pieces[i]}, {}}, design_.search.seed);
            if (given.room.rows < 1 || given.room.columns < 1 || !one.each_fits(given.room)) alone = i;
        }
        if (alone < in.size()) {
            leave_out(alone);
            continue;
        }
        MaskPacker packer(std::move(some), design_.search.seed);
        MaskLayout layout = packer.laid_in_order(given.room, 0);
        fit =
            in.size() < masks.items.size() && packer.separate(given.room, layout, 60, explaining_work() / 2);
        if (fit) break;
        std::size_t worst = 0;
        for (std::size_t i = 0; i < in.size(); ++i)
            if (!masks.locked[in[i]] &&
                packer.clashes(given.room, layout, i) >= packer.clashes(given.room, layout, worst))
                worst = i;
        leave_out(worst);
    }
    return {ErrorKind::does_not_fit,
            say("arrange.does_not_fit", {{"items", masks.items.size()},
                                         {"fit", in.size()},
                                         {"left", left},
                                         {"space", dimensions(given.space.size())},
                                         {"holds", what_holds_all(given.space.blocks)}})};
}

/// The space, as much like the given one as may be, that would hold all, in a sentence of its own; none where
/// that was not found.
std::vector<Message> Arranger::what_holds_all(Vec3i given_blocks) {
    if (masks_->any_locked()) return {};
    Design free = design_;
    free.case_options.inside_mm.reset();
    free.space.block_mm = masks_->block_mm;
    free.space.blocks.reset();
    free.space.wall_mm = wanted_wall_mm(free.space);
    const ArrangeWatch nobody;
    Arranger other(objects_, free, locked_, explaining_work(), nobody);
    other.masks_ = masks_;
    other.like_ = given_blocks;
    const auto found = other.in_free_space();
    if (!found) return {};
    return {say("arrange.holds", {{"blocks", dimensions(vec_cast<double>(found->space.blocks), 0)}})};
}

}  // namespace snug
