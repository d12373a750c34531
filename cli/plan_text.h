#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "snug/plan.h"

namespace snug::cli {

/// What is typed to make a proposal.
struct PlanPlaces {
    std::vector<std::filesystem::path> objects;
    std::optional<std::string> folder;  ///< that the proposals stand in; none: nowhere
};

/// The proposals one below the other: foam, case, cost, drop, work, and what to worry about.
[[nodiscard]] std::string plan_text(std::span<const Proposal> proposals, const PlanPlaces& places,
                                    Language language);

}  // namespace snug::cli
