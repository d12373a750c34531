#include <string_view>

#include "snug/design/cases.h"
#include "snug/words/words.h"

#include "fuzz/check_mesh.h"

// Lists of cases: whatever the text, the lines that are used are written and read again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const snug::CaseList list = snug::parse_cases({reinterpret_cast<const char*>(data), size});
    for (const snug::Message& problem : list.problems) snug::fuzz::require(!snug::text(problem).empty());
    const snug::CaseList again = snug::parse_cases(snug::cases_csv(list.cases));
    snug::fuzz::require(again.problems.empty() && again.cases.size() == list.cases.size());
    return 0;
}
