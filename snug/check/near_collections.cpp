#include "snug/check/near_collections.h"

#include <string_view>
#include <utility>

namespace snug {
namespace {

bool is_named(const Design& design, std::string_view beginning) {
    return design.protection.foam && std::string_view(design.protection.foam->name).starts_with(beginning);
}

}  // namespace

void find_near_collections(const Design& design, std::vector<Finding>& findings) {
    if (design.protection.fragility != FragilityClass::museum) return;
    std::vector<Message> known;
    if (is_named(design, "ethafoam")) known.push_back(say("near.ethafoam"));
    if (is_named(design, "ld33")) known.push_back(say("near.plastazote"));
    if (!design.protection.foam) known.push_back(say("near.unknown"));
    if (design.workshop.work == Workshop::print) known.push_back(say("near.printed"));
    known.push_back(say("near.name_it"));
    known.push_back(say("near.liner"));
    findings.push_back({Severity::note, say("near_collections", {{"known", std::move(known)}})});
}

}  // namespace snug
