#pragma once

namespace snug {

enum class Half { lower, lid };

}  // namespace snug
