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
             "left_out",
             grouped(read.left_out_faces) + " of " + counted(read.faces, "face", "faces") +
                 " of the file were left out: they have fewer than three corners, or a corner "
                 "whose place is no number. Look whether the object is whole, or repair it and "
                 "export it again",
             {}});
    if (read.left_out_points > 0)
        findings.push_back({severity(read.left_out_points, points),
                            "left_out",
                            grouped(read.left_out_points) + " of " + counted(points, "point", "points") +
                                " of the file were left out: their places are no numbers. Look whether the "
                                "object is whole, or scan it again",
                            {}});
}

void find_left_out_objects(const std::vector<std::string>& names, std::vector<Finding>& findings) {
    if (names.empty()) return;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kObjectsNamed); ++i)
        list += (i > 0 ? ", " : "") + quoted(names[i], 80);
    if (names.size() > kObjectsNamed) list += " and " + grouped(names.size() - kObjectsNamed) + " more";
    findings.push_back({Severity::warning,
                        "left_out_objects",
                        "there are several objects in the file, and the foams are for one of them: " + list +
                            (names.size() == 1 ? " is" : " are") + " left out. Make foams for each by itself",
                        {}});
}

}  // namespace

void find_read_notes(const ReadNotes& read, std::size_t left, const std::optional<Unit>& units,
                     std::vector<Finding>& findings) {
    find_left_out(read, left + read.left_out_points, findings);
    find_left_out_objects(read.left_out_objects, findings);
    if (read.no_end)
        findings.push_back(
            {Severity::warning,
             "no_end",
             "the file stops without \"endsolid\", so its end may be missing: look whether the "
             "object is whole, or copy or export it again",
             {}});
    if (read.in_mm && units && *units != Unit::mm)
        findings.push_back(
            {Severity::warning,
             "unit_stated",
             "the design says that the file is in " + std::string(name_of(*units)) +
                 ", but the file states its unit itself, and that counts. If the object has the "
                 "wrong size, choose its scale or its longest side",
             {}});
}

}  // namespace snug
