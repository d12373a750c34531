#include "snug/fabricate/kit/workshop_pack.h"

#include <utility>

#include "snug/base/text.h"

namespace snug {

Message litres_text(double litres) {
    return say("figure.litres", {{"litres", number(litres, 2)}});
}

PackFile text_file(std::string name, std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {std::move(name), {data, data + text.size()}};
}

}  // namespace snug
