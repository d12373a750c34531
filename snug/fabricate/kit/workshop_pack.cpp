#include "snug/fabricate/kit/workshop_pack.h"

#include <utility>

namespace snug {

PackFile text_file(std::string name, std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {std::move(name), {data, data + text.size()}};
}

}  // namespace snug
