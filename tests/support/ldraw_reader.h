#pragma once

#include <array>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace snug::test {

/// A part as an LDraw file places it, read by nothing of Snug's own.
struct PlacedPart {
    int color = 0;
    std::array<int, 3> at{};
    std::array<int, 9> matrix{};
    std::string file;
    int step = 0;  ///< of its model, from 0
};

/// Models of an MPD file by name; throws nothing, and leaves out lines that are no parts.
struct LdrawModels {
    std::map<std::string, std::vector<PlacedPart>> models;
    std::vector<std::string> names;  ///< in their order
    bool ends_in_crlf = true;
};

[[nodiscard]] inline LdrawModels read_ldraw(const std::string& text) {
    LdrawModels result;
    std::string name, line;
    int step = 0;
    std::istringstream lines(text);
    while (std::getline(lines, line)) {
        if (line.empty() || line.back() != '\r') result.ends_in_crlf = false;
        std::istringstream words(line);
        std::string type;
        words >> type;
        if (type == "0") {
            std::string command;
            words >> command;
            if (command == "FILE") {
                words >> name;
                result.names.push_back(name);
                result.models[name];
                step = 0;
            }
            if (command == "STEP") ++step;
        }
        if (type != "1") continue;
        PlacedPart part;
        words >> part.color;
        for (int& value : part.at) words >> value;
        for (int& value : part.matrix) words >> value;
        words >> part.file;
        part.step = step;
        result.models[name].push_back(part);
    }
    return result;
}

}  // namespace snug::test
