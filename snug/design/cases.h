#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/case_options.h"

namespace snug {

/// A carton, hard case or parcel class that can be bought. What is not known stays empty.
struct KnownCase {
    std::string name;
    std::string kind;               ///< carton, hard case, parcel class
    std::string maker;              ///< of a carton or hard case: "Peli"
    Vec3d inside_mm;                ///< height, width, length; length is the longer side of the floor
    std::optional<double> lid_mm;   ///< of the height, what belongs to the lid
    std::optional<double> tare_kg;  ///< empty
    std::optional<double> price;    ///< in the currency of the list
    std::optional<double> most_kg;  ///< gross mass that it may have
    std::string carrier;            ///< whose class it is
    std::optional<double> divisor;  ///< cm3 for one kg of volumetric weight
    std::string source;             ///< where the sizes are from
    /// Whether a carrier charges one price for it, whatever its volume.
    [[nodiscard]] bool has_flat_rate() const { return kind == "parcel class" && !divisor; }
    friend bool operator==(const KnownCase&, const KnownCase&) = default;
};

/// What a list of cases holds, and what is wrong with each line that could not be used ("line 7: ...").
struct CaseList {
    std::vector<KnownCase> cases;
    std::vector<Message> problems;
};

/// The cases that Snug brings.
[[nodiscard]] const std::vector<KnownCase>& built_in_cases();

/// Cases from comma-separated text. The first line names the columns, in any order: name, kind, length_mm,
/// width_mm, height_mm, lid_mm, tare_kg, price, most_kg, carrier, divisor, source, maker; name and the three
/// sizes are required. Empty lines and lines that begin with # are passed over; a bad line is named and the
/// others are used.
[[nodiscard]] CaseList parse_cases(std::string_view csv);

/// The same as text, which parse_cases() reads back.
[[nodiscard]] std::string cases_csv(const std::vector<KnownCase>& cases);

/// The last case of that name, or of that maker and name ("Peli 1450"), capitals passed over where no name is
/// the same to the letter; else an Error (kind usage).
[[nodiscard]] Result<KnownCase> find_case(const std::vector<KnownCase>& known, std::string_view name);

/// Sets name, inside, lid and divisor (5000 where the case does not say its own and has no flat rate); play,
/// shape and division stay.
void apply(const KnownCase& known, CaseOptions& options);

}  // namespace snug
