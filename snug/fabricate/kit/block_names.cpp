#include "snug/fabricate/kit/block_names.h"

namespace snug {

std::string row_name(int row_from_back) {
    std::string name;
    for (int rest = row_from_back; rest >= 0; rest = rest / 26 - 1)
        name.insert(name.begin(), static_cast<char>('A' + rest % 26));
    return name;
}

std::string column_name(int column) {
    return std::to_string(column + 1);
}

}  // namespace snug
