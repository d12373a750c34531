#include "snug/mesh/left_out.h"

namespace snug {
namespace {

std::optional<Error> refusal(const char* code, std::size_t left_out, std::size_t all) {
    if (left_out <= all / 2) return {};
    return Error{ErrorKind::input, say(code, {{"left_out", left_out}, {"all", all}})};
}

}  // namespace

std::optional<Error> too_much_left_out(const ReadNotes& read, std::size_t points) {
    if (auto error = refusal("mesh.points_left_out", read.left_out_points, points)) return error;
    return refusal("mesh.faces_left_out", read.left_out_faces, read.faces);
}

}  // namespace snug
