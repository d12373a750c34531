#pragma once

namespace snug {

/// The two sides of a layer. A piece that is seen as a lower half is seen from +x, one that is seen as a lid
/// from -x; its cavity faces the reader.
enum class Half { lower, lid };

}  // namespace snug
