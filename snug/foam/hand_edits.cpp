#include "snug/foam/hand_edits.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "snug/foam/item_cuts.h"
#include "snug/foam/object_cut.h"

namespace snug {
namespace {

constexpr int kShares = 4;  // parts of the clearance that are told apart

/// What no foam may enter: of each layer what its items cut that have only a share of their clearance, none
/// at first and all of it at last, and what their zones keep free.
using Barred = std::array<std::vector<BlockMap>, kShares + 1>;

Clearance without_studs(CutOptions cut) {
    cut.stud_mm = 0;
    return cut.whole_clearance_mm();
}

std::vector<Item> with_clearance(std::vector<Item> items, double share) {
    for (Item& item : items) {
        const Clearance whole = without_studs(item.cut);
        item.cut.clearance_mm = {whole.lower * share, whole.upper * share};
        item.cut.liner_mm = 0;
    }
    return items;
}

Result<Barred> barred_by(const EditedFoam& foam, std::size_t layers, const Progress& progress) {
    Barred barred;
    for (int part = 0; part <= kShares; ++part) {
        const auto items = with_clearance(foam.items, double(part) / kShares);
        const auto all = cut_items(foam.objects, items, foam.space, nullptr,
                                   part_of(progress, part / (kShares + 1.0), (part + 1) / (kShares + 1.0)));
        if (!all) return tl::unexpected(all.error());
        for (std::size_t layer = 0; layer < layers; ++layer) {
            std::vector<const HalfCuts*> own;
            for (std::size_t i = 0; i < items.size(); ++i)
                if (items[i].layer == static_cast<int>(layer) + 1) own.push_back(&all->cuts[i]);
            barred[static_cast<std::size_t>(part)].push_back(cut_by_both(united(own), foam.parting[layer]));
        }
    }
    return barred;
}

/// Where an edit is: a face of the foam below a layer, or of the foam above it.
struct Face {
    std::size_t layer = 0;
    bool below = true;  ///< the foam below the layer ends there
};

std::optional<Face> face_of(const HandEdit& edit, std::size_t layers) {
    if (edit.piece == "lower") return Face{0, true};
    if (edit.piece == "upper") return Face{layers - 1, false};
    const auto number = static_cast<std::size_t>(middle_number(edit).value_or(0));
    if (number < 1 || number >= layers) return {};
    return edit.under ? Face{number - 1, false} : Face{number, true};
}

/// One column of a layer, as an edit finds it.
class Column {
  public:
    Column(const EditedFoam& foam, std::vector<BlockMap>& layers, Face face, int j, int k)
        : foam_(foam), layers_(layers), face_(face), j_(j), k_(k), cut_(whole(face.layer)) {}

    /// Blocks that the piece has there.
    [[nodiscard]] int foam_blocks() const {
        const Run exists = foam_.available(j_, k_);
        if (face_.below)
            return cut_.first -
                   (face_.layer == 0 ? exists.first : std::max(exists.first, whole(face_.layer - 1).end));
        const bool last = face_.layer + 1 == layers_.size();
        return (last ? exists.end : std::min(exists.end, whole(face_.layer + 1).first)) - cut_.end;
    }

    /// Blocks that are cut there and can be put back: in a tray none above its surface, and elsewhere not so
    /// many that the pieces meet, but at the parting level.
    [[nodiscard]] int cut_blocks() const {
        const int level = foam_.parting[face_.layer];
        const bool uncovered = foam_.open && face_.layer + 1 == layers_.size();
        if (uncovered && cut_.end > level) return std::max(0, level - cut_.first);
        const int other = face_.below ? cut_.end : cut_.first;
        return std::max(0, cut_.blocks() - (other == level ? 0 : 1));
    }

    /// The blocks that putting so many back fills.
    [[nodiscard]] Run filled(int blocks) const {
        return face_.below ? run(cut_.first, cut_.first + blocks) : run(cut_.end - blocks, cut_.end);
    }

    void take(int blocks) {
        if (face_.below)
            cut_.first = static_cast<std::int16_t>(cut_.first - blocks);
        else
            cut_.end = static_cast<std::int16_t>(cut_.end + blocks);
        layers_[face_.layer](j_, k_) = cut_;
    }

    [[nodiscard]] Vec3d where() const {
        const Vec3d block = foam_.space.block_mm;
        const Vec3d corner = foam_.space.box().min;
        const int level = face_.below ? cut_.first : cut_.end;
        return {corner.x + level * block.x, corner.y + (j_ + 0.5) * block.y, corner.z + (k_ + 0.5) * block.z};
    }

  private:
    static Run run(int first, int end) {
        return {static_cast<std::int16_t>(first), static_cast<std::int16_t>(end)};
    }
    /// Where nothing is cut, the pieces meet at the parting level.
    [[nodiscard]] Run whole(std::size_t layer) const {
        const Run cut = layers_[layer](j_, k_);
        return cut.none() ? run(foam_.parting[layer], foam_.parting[layer]) : cut;
    }

    const EditedFoam& foam_;
    std::vector<BlockMap>& layers_;
    Face face_;
    int j_, k_;
    Run cut_;
};

double least_clearance(const std::vector<Item>& items, std::size_t layer) {
    std::optional<double> least;
    for (const Item& item : items)
        if (item.layer == static_cast<int>(layer) + 1)
            least = std::min(least.value_or(kGreatestLength), without_studs(item.cut).least());
    return std::max(0.0, least.value_or(0));
}

/// Of the shares of the clearance how many stay free beside what is filled.
int free_shares(Run filled, const HandEdit& edit, std::size_t layer, const Barred& barred) {
    int free = 0;
    while (free < kShares && !filled.meets(barred[static_cast<std::size_t>(free) + 1][layer](edit.j, edit.k)))
        ++free;
    return free;
}

/// Into `outcome` and the layers.
void apply(const HandEdit& edit, const EditedFoam& foam, const Barred& barred, std::vector<BlockMap>& layers,
           EditOutcome& outcome) {
    const auto refuse = [&](Message why) { outcome.why_not = std::move(why); };
    const auto face = face_of(edit, layers.size());
    if (!face || (foam.open && edit.piece == "upper")) return refuse(say("edit.no_piece"));
    if (!foam.available.contains(edit.j, edit.k) || foam.available(edit.j, edit.k).none())
        return refuse(say("edit.no_column"));
    Column column(foam, layers, *face, edit.j, edit.k);
    outcome.where = column.where();
    if (edit.blocks > column.foam_blocks())
        return refuse(say("edit.no_foam", {{"blocks", std::max(0, column.foam_blocks())}}));
    if (-edit.blocks > column.cut_blocks())
        return refuse(say("edit.not_cut", {{"blocks", column.cut_blocks()}}));
    if (edit.blocks < 0) {
        const Run filled = column.filled(-edit.blocks);
        if (filled.meets(barred[0][face->layer](edit.j, edit.k))) return refuse(say("edit.enters"));
        const int free = free_shares(filled, edit, face->layer, barred);
        if (free < kShares) outcome.left_mm = least_clearance(foam.items, face->layer) * free / kShares;
    }
    column.take(edit.blocks);
    outcome.blocks = edit.blocks;
}

}  // namespace

Result<std::vector<EditOutcome>> apply_edits(const HandEdits& edits, const EditedFoam& foam,
                                             std::vector<BlockMap>& layers, const Progress& progress) {
    const bool puts_back =
        std::any_of(edits.begin(), edits.end(), [](const HandEdit& edit) { return edit.blocks < 0; });
    Barred barred;
    if (puts_back) {
        auto found = barred_by(foam, layers.size(), progress);
        if (!found) return tl::unexpected(found.error());
        barred = std::move(*found);
    }
    std::vector<EditOutcome> outcomes;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        outcomes.emplace_back().edit = i;
        apply(edits[i], foam, barred, layers, outcomes.back());
    }
    return outcomes;
}

}  // namespace snug
