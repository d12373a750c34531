#include "snug/object/read_findings.h"

#include <algorithm>
#include <string>

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr std::size_t kObjectsNamed = 5;
constexpr std::size_t kFewest = 100;  // one in so many left out is still a warning

Severity severity(std::size_t left_out, std::size_t all) {
    return left_out > all / kFewest ? Severity::danger : Severity::warning;
}

void find_left_out(const ReadNotes& read, std::size_t points, std::vector<Finding>& findings) {
    if (read.left_out_faces > 0)
        findings.push_back(
            {severity(read.left_out_faces, read.faces),
             say("left_out/faces", {{"left_out", read.left_out_faces}, {"faces", read.faces}})});
    if (read.left_out_points > 0)
        findings.push_back(
            {severity(read.left_out_points, points),
             say("left_out/points", {{"left_out", read.left_out_points}, {"points", points}})});
}

void find_left_out_objects(const std::vector<std::string>& names, std::vector<Finding>& findings) {
    if (names.empty()) return;
    std::vector<Message> named, more;
    for (std::size_t i = 0; i < std::min(names.size(), kObjectsNamed); ++i)
        named.push_back(as_it_is(quoted(names[i], 80)));
    if (names.size() > kObjectsNamed)
        more.push_back(say("and_more", {{"count", names.size() - kObjectsNamed}}));
    findings.push_back(
        {Severity::warning,
         say("left_out_objects", {{"names", named}, {"more", more}, {"objects", names.size()}})});
}

}  // namespace

void find_read_notes(const ReadNotes& read, std::size_t left, const std::optional<Unit>& units,
                     std::vector<Finding>& findings) {
    find_left_out(read, left + read.left_out_points, findings);
    find_left_out_objects(read.left_out_objects, findings);
    if (read.no_end) findings.push_back({Severity::warning, say("no_end")});
    if (read.in_mm && units && *units != Unit::mm)
        findings.push_back({Severity::warning, say("unit_stated", {{"unit", name_of(*units)}})});
}

}  // namespace snug
