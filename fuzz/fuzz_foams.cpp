#include <string_view>

#include "snug/design/known_foams.h"
#include "snug/words/words.h"

#include "fuzz/check_mesh.h"

// Lists of foams: whatever the text, it is refused with a sentence, or every foam's curve can be fallen on.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using snug::fuzz::require;
    const auto foams = snug::parse_foams({reinterpret_cast<const char*>(data), size});
    if (!foams) {
        require(!snug::text(foams.error().message).empty());
        return 0;
    }
    for (const snug::FoamMaterial& foam : *foams) {
        require(!foam.name.empty() && !snug::problem_of(foam));
        if (foam.curve.empty()) continue;
        for (const snug::StressCurve& curve : snug::with_other_plateaus(foam.curve))
            if (const auto strain = curve.strain_of_drop(5, 10))
                require(*strain >= 0 && *strain <= curve.greatest_strain() && curve.at(*strain).kpa >= 0);
    }
    return 0;
}
