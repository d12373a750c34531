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

void sort_by_severity(std::vector<Finding>& findings) {
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
}

}  // namespace snug
