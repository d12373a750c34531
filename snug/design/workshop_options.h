#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/base/vec2.h"
#include "snug/design/brick_options.h"
#include "snug/design/mill_options.h"
#include "snug/design/mould_options.h"
#include "snug/design/print_options.h"
#include "snug/design/sheet_options.h"

namespace snug {

/// A way of working, which decides what a maker is handed. `none`: the foams' own files only.
enum class Workshop { none, sponge, sheets, print, bricks, mill, mould };
[[nodiscard]] std::string_view workshop_name(Workshop workshop);  ///< "sponge"; empty for none
[[nodiscard]] std::optional<Workshop> workshop_from_name(std::string_view name);

/// "sponge, sheets or print": all that there are.
[[nodiscard]] std::string workshop_names();

/// Why a name is no way of working, and which ones there are.
[[nodiscard]] std::string unknown_workshop(std::string_view name);

/// The preset that a way of working takes where none is named.
[[nodiscard]] std::string_view usual_preset(Workshop workshop);

struct WorkshopOptions {
    Workshop work = Workshop::none;
    std::string paper = "a4";               ///< a4, letter or a3
    std::optional<double> price_per_litre;  ///< of the material, 0 or more; none: the cost is not known
    std::string currency;                   ///< as it stands behind the price: "EUR"; may be empty
    std::optional<double> mass_kg;          ///< of the object, above 0; none: not known
    std::optional<double> density_kg_m3;    ///< of the material, above 0; none: the preset's
    SheetOptions sheets;
    PrintOptions print;
    BrickOptions bricks;
    MillOptions mill;
    MouldOptions mould;
    friend bool operator==(const WorkshopOptions&, const WorkshopOptions&) = default;
};

/// A sheet of this paper, upright; A4 where the name is none that problem_of() takes.
[[nodiscard]] Vec2d paper_mm(std::string_view paper);

/// What is out of range, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const WorkshopOptions& options);

}  // namespace snug
