#include "snug/fabricate/kit/workshop_pack.h"

#include <utility>

#include "snug/base/text.h"
#include "snug/design/workshop_options.h"

namespace snug {

std::vector<Message> ways_for_layers() {
    std::vector<Message> ways;
    for (const Workshop way : {Workshop::sponge, Workshop::sheets, Workshop::print, Workshop::mill})
        ways.push_back(as_it_is(name_of(way)));
    return ways;
}

Message litres_text(double litres) {
    return say("figure.litres", {{"litres", number(litres, 2)}});
}

PackFile text_file(std::string name, std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {std::move(name), {data, data + text.size()}};
}

}  // namespace snug
