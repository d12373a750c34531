#include "tests/support/gcode_stock.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

namespace snug::test {
namespace {

/// A line's letters and numbers; what GRBL would refuse is told.
std::multimap<char, double> words_of(const std::string& line, std::vector<std::string>& problems) {
    std::multimap<char, double> words;
    for (std::size_t i = 0; i < line.size();) {
        if (line[i] == ' ') {
            ++i;
            continue;
        }
        const char letter = line[i++];
        std::size_t end = i;
        while (end < line.size() &&
               (std::isdigit(static_cast<unsigned char>(line[end])) || line[end] == '.' || line[end] == '-'))
            ++end;
        const std::string number = line.substr(i, end - i);
        const std::size_t point = number.find('.');
        if (std::string("GMXYZFSPIJ").find(letter) == std::string::npos || number.empty() ||
            (point != std::string::npos && number.size() - point > 4))
            problems.push_back(line);
        words.emplace(letter, std::atof(number.c_str()));
        i = std::max(end, i);
        if (number.empty()) break;
    }
    return words;
}

}  // namespace

GcodeProgram read_gcode(const std::string& text) {
    static const std::set<double> known_g{0, 1, 2, 4, 17, 21, 54, 90, 94}, known_m{3, 5, 30};
    GcodeProgram program;
    std::istringstream lines(text);
    std::string line;
    Vec3d at;
    int motion = -1;
    double feed = 0;
    std::set<char> known_axes;
    bool stopped = false;
    while (std::getline(lines, line)) {
        if (line.size() > 80) program.problems.push_back("long: " + line);
        for (const char c : line)
            if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126)
                program.problems.push_back("letters: " + line);
        const std::size_t open = line.find('(');
        if (open != std::string::npos) {
            if (line.back() != ')' || line.find('(', open + 1) != std::string::npos)
                program.problems.push_back("comment: " + line);
            line = line.substr(0, open);
        }
        const auto words = words_of(line, program.problems);
        if (words.empty()) continue;
        if (program.ended) program.problems.push_back("after the end: " + line);
        Vec3d to = at;
        Vec2d middle;
        bool moves = false, dwell = false;
        for (const auto& [letter, value] : words) {
            if (letter == 'G') {
                if (!known_g.count(value)) program.problems.push_back(line);
                if (value <= 3) motion = static_cast<int>(value);
                dwell = dwell || value == 4;
            }
            if (letter == 'M') {
                if (!known_m.count(value)) program.problems.push_back(line);
                if (value == 3) program.spindle_on = true;
                stopped = stopped || value == 5;
                program.ended = program.ended || (value == 30 && stopped);
            }
            if (letter == 'F') feed = value;
            if (letter == 'X') to.x = value;
            if (letter == 'Y') to.y = value;
            if (letter == 'Z') to.z = value;
            if (letter == 'I') middle.x = at.x + value;
            if (letter == 'J') middle.y = at.y + value;
            if (letter == 'X' || letter == 'Y' || letter == 'Z') {
                moves = true;
                known_axes.insert(letter);
            }
        }
        if (dwell || !moves) continue;
        if (motion != 0 && feed <= 0) program.problems.push_back("no feed: " + line);
        if (motion != 0 && !program.spindle_on) program.problems.push_back("no spindle: " + line);
        if (motion == 2) {
            const double radius = std::hypot(at.x - middle.x, at.y - middle.y);
            const double begin = std::atan2(at.y - middle.y, at.x - middle.x);
            Vec3d from = at;
            for (int i = 1; i <= 90; ++i) {
                const double angle = begin - 2 * M_PI * i / 90;
                const Vec3d next{middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle),
                                 at.z};
                program.moves.push_back({false, from, next, feed});
                from = next;
            }
            continue;
        }
        if (known_axes.size() == 3 && (to.x != at.x || to.y != at.y || to.z != at.z))
            program.moves.push_back({motion == 0, at, to, motion == 0 ? 0 : feed});
        at = to;
    }
    return program;
}

GcodeStock::GcodeStock(Vec3d size, double cell)
    : cell_(cell),
      top_(size.z),
      height_(static_cast<int>(std::lround(size.y / cell)), static_cast<int>(std::lround(size.x / cell)),
              size.z) {}

double GcodeStock::at(Vec2d mm) const {
    const int row = std::clamp(static_cast<int>(mm.y / cell_), 0, height_.ny() - 1);
    const int column = std::clamp(static_cast<int>(mm.x / cell_), 0, height_.nz() - 1);
    return height_(row, column);
}

void GcodeStock::cut(const GcodeMove& move, double radius) {
    const double bottom = std::min(move.from.z, move.to.z) + top_;
    if (bottom >= top_) return;
    const Vec2d a{move.from.x, move.from.y}, b{move.to.x, move.to.y};
    const auto index = [&](double mm, int count) {
        return std::clamp(static_cast<int>(std::floor(mm / cell_)), 0, count - 1);
    };
    for (int row = index(std::min(a.y, b.y) - radius, height_.ny());
         row <= index(std::max(a.y, b.y) + radius, height_.ny()); ++row)
        for (int column = index(std::min(a.x, b.x) - radius, height_.nz());
             column <= index(std::max(a.x, b.x) + radius, height_.nz()); ++column) {
            const Vec2d p = middle(row, column), along = b - a, away = p - a;
            const double square = along.x * along.x + along.y * along.y;
            const double share =
                square > 0 ? std::clamp((away.x * along.x + away.y * along.y) / square, 0.0, 1.0) : 0;
            if (length(away - along * share) <= radius)
                height_(row, column) = std::min(height_(row, column), bottom);
        }
}

}  // namespace snug::test
