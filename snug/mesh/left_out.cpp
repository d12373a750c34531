#include "snug/mesh/left_out.h"

#include <string>

#include "snug/base/text.h"

namespace snug {
namespace {

std::optional<Error> refusal(std::size_t left_out, std::size_t all, const char* noun, const char* why) {
    if (left_out <= all / 2) return {};
    return Error{ErrorKind::input,
                 grouped(left_out) + " of " + grouped(all) + " " + noun + " have " + why +
                     " not a number, or beyond 1e30: too little would be left; repair it or "
                     "export it again"};
}

}  // namespace

std::optional<Error> too_much_left_out(const ReadNotes& read, std::size_t points) {
    if (auto error = refusal(read.left_out_points, points, "points", "a coordinate that is")) return error;
    return refusal(read.left_out_faces, read.faces, "faces",
                   "fewer than three corners or a corner with a coordinate that is");
}

}  // namespace snug
