#pragma once

#include <optional>
#include <vector>

#include "snug/base/message.h"
#include "snug/check/protection_report.h"

namespace snug {

/// What the drops of a pack are called wherever they are told: "from 970 mm, height from ISTA 2A; not a test
/// of it, in LD33 (maker's sheet, to 60 %, pressed slowly)". The pack has a height and a foam.
[[nodiscard]] Message drop_text(const Protection& protection);

/// "on its back 34 to 49 G, 21 mm deep", of the item that is worst off on each face and, among several, its
/// name, or what is missing.
[[nodiscard]] std::vector<Message> face_texts(const Protection& protection);

/// What the items are taken to bear: "taken to bear: 40 G", "taken to bear: camera 60 G, lens 40 G"; none
/// where nothing was asked.
[[nodiscard]] std::optional<Message> borne_text(const Protection& protection);

/// What the estimate leaves out: "trapped air".
[[nodiscard]] std::vector<Message> not_computed();

/// What is known of how a foam pushes back: "to 60 %, pressed slowly"; "-" where nothing is.
[[nodiscard]] Message curve_text(const FoamMaterial& foam);

/// "maker's sheet"
[[nodiscard]] Message status_text(FoamStatus status);

}  // namespace snug
