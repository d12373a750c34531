#pragma once

#include "snug/formats/xml_read.h"

namespace snug {

/// Whether a namespace is that of 3MF's own elements, which a few programs leave out.
[[nodiscard]] bool is_3mf_core(std::string_view space);

/// How the namespaces of the production extension begin.
inline constexpr std::string_view kThreeMfProduction =
    "http://schemas.microsoft.com/3dmanufacturing/production/";

/// At the start of a `model`: fails (input) where it requires an extension that Snug does not know. What is
/// known is either about looks and ways of printing, or is refused where a placed object is made of it.
[[nodiscard]] Result<void> check_required_extensions(XmlReader& xml);

}  // namespace snug
