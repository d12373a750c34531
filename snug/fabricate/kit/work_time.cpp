#include "snug/fabricate/kit/work_time.h"

namespace snug {

double seconds_each(Workshop work) {
    switch (work) {
        case Workshop::none:
            return 0;
        case Workshop::sponge:
            return 3;
        case Workshop::sheets:
            return 60;
        case Workshop::print:
            return 300;
        case Workshop::bricks:
            return 4;
        case Workshop::mill:
            return 900;
        case Workshop::mould:
            return 600;
    }
    return 0;
}

}  // namespace snug
