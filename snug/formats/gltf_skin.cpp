#include "snug/formats/gltf_skin.h"

#include <utility>

namespace snug::gltf {
namespace {

Affine matrix_at(const Accessor& matrices, std::uint64_t i) {
    Affine result;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result.row[static_cast<std::size_t>(row)][column] = matrices.at(i, 4 * column + row);
    result.shift = {matrices.at(i, 12), matrices.at(i, 13), matrices.at(i, 14)};
    return result;
}

}  // namespace

Result<const std::vector<Affine>*> Skins::pose(std::uint64_t index) {
    if (const auto known = known_.find(index); known != known_.end()) return &known->second;
    const Json& skin = item(field(scene_, "skins"), index);
    if (!skin.is_object()) return refuse(say("gltf.no_skin", {{"index", index}}));
    const Json& joints = field(skin, "joints");
    Accessor inverse;
    const bool bound = !field(skin, "inverseBindMatrices").is_null();
    if (bound) {
        const auto matrices = whole(skin, "inverseBindMatrices", 0);
        if (!matrices) return tl::unexpected(matrices.error());
        auto accessor = Accessor::open(scene_, buffers_, *matrices, "MAT4");
        if (!accessor) return tl::unexpected(accessor.error());
        inverse = std::move(*accessor);
        if (inverse.count() < count_of(joints))
            return refuse(
                say("gltf.skin_matrices",
                    {{"index", index}, {"joints", count_of(joints)}, {"matrices", inverse.count()}}));
    }
    std::vector<Affine> pose;
    for (std::uint64_t i = 0; i < count_of(joints); ++i) {
        const auto node = whole_value(item(joints, i), "joints");
        if (!node) return tl::unexpected(node.error());
        const auto world = nodes_.world(*node);
        if (!world) return tl::unexpected(world.error());
        pose.push_back(bound ? *world * matrix_at(inverse, i) : *world);
    }
    return &known_.emplace(index, std::move(pose)).first->second;
}

}  // namespace snug::gltf
