#include "snug/design/carrier.h"

namespace snug {

void expect_drops(Carrier carrier, Design& design) {
    constexpr double kCarriedHeight = 760;  // mm
    if (design.protection.drops() || design.space.open || carrier == Carrier::store) return;
    if (carrier == Carrier::hand)
        design.protection.height_mm = kCarriedHeight;
    else
        design.protection.rule = DropRule::ista_2a;
}

double usual_wall_mm(Workshop work, Carrier carrier) {
    if (work == Workshop::print) return 6;
    if (work == Workshop::bricks) return 16;
    return carrier == Carrier::store ? 25 : 50;
}

}  // namespace snug
