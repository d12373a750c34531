#include "snug/samples/samples.h"

#include <string>

#include "snug/base/text.h"
#include "snug/samples/sample_solids.h"

namespace snug {
namespace {

Mesh torus_sample() {
    Mesh mesh;
    add_ring(mesh, {{}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, 55, 25, 120, 60);
    return mesh;
}

struct Sample {
    std::string_view name;
    Mesh (*make)();
};
constexpr Sample kSamples[] = {
    {"torus", torus_sample}, {"vase", vase_sample}, {"camera", camera_sample}, {"figurine", figurine_sample}};

}  // namespace

std::vector<std::string_view> sample_names() {
    std::vector<std::string_view> names;
    for (const Sample& sample : kSamples) names.push_back(sample.name);
    return names;
}

Result<Mesh> sample(std::string_view name) {
    std::string known;
    for (const Sample& each : kSamples) {
        if (each.name == name) return each.make();
        known += (known.empty() ? "" : ", ") + std::string(each.name);
    }
    return fail(ErrorKind::usage, say("sample.unknown", {{"name", quoted(name)}, {"known", known}}));
}

}  // namespace snug
