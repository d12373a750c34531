#include "snug/formats/xml_read.h"
#include "snug/words/words.h"

#include "fuzz/check_mesh.h"

/// Whatever the bytes are, the reader ends, every start has its end, and an error says something.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace snug;
    XmlReader xml(fuzz::bytes(data, size));
    int depth = 0;
    for (std::size_t steps = 0;; ++steps) {
        fuzz::require(steps <= 2 * size + 2);
        const auto event = xml.next();
        if (!event) {
            fuzz::require(!text(event.error().message).empty());
            return 0;
        }
        if (*event == XmlEvent::done) break;
        depth += *event == XmlEvent::start ? 1 : -1;
        fuzz::require(depth >= 0);
        if (*event == XmlEvent::end) continue;
        (void)xml.attribute("a");
        (void)xml.attribute(xml.space(), "a");
    }
    fuzz::require(depth == 0);
    return 0;
}
