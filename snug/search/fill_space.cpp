#include "snug/search/fill_space.h"

#include <algorithm>
#include <utility>

#include "snug/base/stopwatch.h"
#include "snug/base/text.h"
#include "snug/search/arranger.h"
#include "snug/search/arranging.h"

namespace snug {
namespace {

/// What the design of one item has for all is this one's own before others join it.
void give_own(Design& design) {
    ItemOptions& item = design.items.front();
    if (design.items.size() > 1 || item.mass_kg) return;
    item.mass_kg = std::exchange(design.workshop.mass_kg, {});
}

Design with_copies(const Design& design, std::size_t item, int copies) {
    Design more = design;
    ItemOptions copy = design.items[item];
    copy.offset_mm.reset();
    copy.lock = false;
    for (int i = 0; i < copies; ++i) more.items.push_back(copy);
    return more;
}

/// Tries numbers of copies, and keeps the design of the most that went in.
class Filling {
  public:
    Filling(std::span<Object> objects, Design design, std::size_t item, long long work,
            const ArrangeWatch& watch)
        : objects_(objects), design_(std::move(design)), item_(item), work_(work), watch_(watch) {}

    /// `explain`: as arranged() has it, of what is there already.
    Result<Arrangement> run(Design& design, bool explain) {
        if (auto first = look(0, explain); !first) return first;
        int most = 0, too_many = kMostItems - static_cast<int>(design_.items.size()) + 1;
        for (int more = 1; most + 1 < too_many && !cancelled_;) {
            const int copies = std::min(most + more, too_many - 1);
            const auto found = look(copies, false);
            if (!found && found.error().kind != ErrorKind::does_not_fit && !cancelled_) return found;
            (found ? most : too_many) = copies;
            more = found ? 2 * more : std::max(1, (too_many - most) / 2);
        }
        design = std::move(best_);
        arrangement_.cancelled = cancelled_;
        return arrangement_;
    }

  private:
    Result<Arrangement> look(int copies, bool explain) {
        const Design tried = with_copies(design_, item_, copies);
        // Nobody knows how many numbers will be tried: each is as much of what is left.
        const double from = share_;
        const ArrangeWatch watch{[&](double share, std::optional<double> volume_mm3) {
                                     share_ = std::max(share_, from + (1 - from) * share / kTriesToCome);
                                     cancelled_ = watch_.go_on && !watch_.go_on(share_, volume_mm3);
                                     return !cancelled_;
                                 },
                                 {}};
        Design result;
        auto found = Arranger(objects_, tried, locked_items(tried, true), work_, watch).run(result, explain);
        if (!found) return found;
        best_ = std::move(result);
        arrangement_ = *found;
        if (watch_.better) watch_.better(best_);
        return found;
    }

    static constexpr double kTriesToCome = 6;
    std::span<Object> objects_;
    Design design_;
    std::size_t item_;
    long long work_;
    const ArrangeWatch& watch_;
    Design best_;
    Arrangement arrangement_;
    double share_ = 0;
    bool cancelled_ = false;
};

/// By the first wish that leaves room for what is there: a lesser one would always let in more.
Result<Arrangement> filled(std::span<Object> objects, Design& design, std::size_t item, long long work,
                           const ArrangeWatch& watch) {
    const ArrangeWatch told{watch.go_on, [&](const Design& better) {
                                if (watch.better) watch.better(as_asked(better, design));
                            }};
    std::vector<Design> wishes = wishes_to_try(design);
    wishes.push_back(design);
    wishes.back().fit.notches.reset();
    Result<Arrangement> found;
    Design result;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        found = Filling(objects, wishes[i], item, work, told).run(result, i + 1 == wishes.size());
        if (found || found.error().kind != ErrorKind::does_not_fit) break;
    }
    if (found) design = as_asked(std::move(result), design);
    return found;
}

}  // namespace

Result<Arrangement> fill_space(std::span<Object> objects, Design& design, std::size_t item, long long work,
                               const ArrangeWatch& watch) {
    Stopwatch stopwatch;
    if (item >= design.items.size()) return fail(ErrorKind::usage, say("arrange.no_item"));
    if (!has_given_space(design)) return fail(ErrorKind::usage, say("arrange.fills_nothing"));
    if (auto done = begin_arranging(objects, design, watch); !done) return tl::unexpected(done.error());
    Design start = design;
    give_own(start);
    auto found = filled(objects, start, item, work, watch);
    if (found) design = std::move(start);
    if (found) found->ms = stopwatch.lap();
    return found;
}

}  // namespace snug
