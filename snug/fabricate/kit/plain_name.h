#pragma once

#include <string>
#include <string_view>

namespace snug {

/// A name (UTF-8) in what every machine controller reads as mere text: letters and digits of ASCII, spaces
/// and . , : - + / = & ' _, no space at its ends and never two. Accents are left out, other letters become _,
/// one for several, and everything else goes: GRBL takes ! ~ ? out of the stream wherever they stand, even in
/// a comment, and stops or starts the machine; % and ; begin and end programs and comments elsewhere.
[[nodiscard]] std::string plain_name(std::string_view utf8);

}  // namespace snug
