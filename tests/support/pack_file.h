#pragma once

#include <string>

#include "snug/fabricate/kit/workshop_pack.h"

namespace snug::test {

/// A file of the pack; empty where it has none of this name.
[[nodiscard]] inline std::string text_of(const WorkshopPack& pack, const std::string& name) {
    for (const PackFile& file : pack.files)
        if (file.name == name) return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
    return {};
}

}  // namespace snug::test
