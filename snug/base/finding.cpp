#include "snug/base/finding.h"

#include <algorithm>

namespace snug {

std::string_view severity_name(Severity severity) {
    switch (severity) {
        case Severity::danger:
            return "danger";
        case Severity::warning:
            return "warning";
        case Severity::note:
            return "note";
    }
    return "note";
}

std::string_view Finding::code() const {
    return std::string_view(message.code).substr(0, message.code.find('/'));
}

Message said_of_item(const Finding& finding) {
    if (finding.of.empty()) return finding.message;
    return say("in_file", {{"file", finding.of}, {"problem", finding.message}});
}

void sort_by_severity(std::vector<Finding>& findings) {
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
}

}  // namespace snug
