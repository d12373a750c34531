#include "snug/formats/gltf_primitive.h"

#include <cmath>
#include <string>

namespace snug::gltf {
namespace {

constexpr const char* kJoints = "JOINTS_0";
constexpr const char* kWeights = "WEIGHTS_0";
/// Four weights in a byte each add up to one but for their rounding.
constexpr double kWeightRounding = 2.0 / 255;

class PrimitiveReader {
  public:
    PrimitiveReader(const Json& scene, Buffers& buffers, DracoMeshes& draco, const Json& json)
        : scene_(scene), buffers_(buffers), draco_(draco), json_(json) {}

    Result<std::optional<Primitive>> read(std::span<const double> weights) {
        const auto mode = whole(json_, "mode", 4);
        if (!mode) return tl::unexpected(mode.error());
        const Json& attributes = field(json_, "attributes");
        if ((*mode >= 1 && *mode <= 3) || *mode > 6 || field(attributes, "POSITION").is_null())
            return std::optional<Primitive>{};
        primitive_.topology = static_cast<Topology>(*mode);
        if (const auto done = read_points(); !done) return tl::unexpected(done.error());
        if (const auto done = read_morphs(weights); !done) return tl::unexpected(done.error());
        return std::optional<Primitive>(std::move(primitive_));
    }

  private:
    /// Unpacked by Draco, or as they are: where they need not be unpacked and cannot be, too.
    Result<void> read_points() {
        const Json& packed = extension(json_, DracoMeshes::kExtension);
        if (!packed.is_object()) return read_plain();
        auto done = read_packed(packed);
        if (done || draco_.required()) return done;
        primitive_.influence.reset();
        return read_plain() ? Result<void>{} : done;
    }

    Result<Accessor> open(const Json& of, const char* name, const char* type) {
        const auto index = whole(of, name, 0);
        if (!index) return tl::unexpected(index.error());
        return Accessor::open(scene_, buffers_, *index, type);
    }

    Result<void> read_plain() {
        const Json& attributes = field(json_, "attributes");
        auto positions = open(attributes, "POSITION", "VEC3");
        if (!positions) return tl::unexpected(positions.error());
        primitive_.positions = std::move(*positions);
        if (primitive_.positions.claimed() && primitive_.positions.count() > buffers_.bytes_read())
            return refuse(say("gltf.points_without_bytes", {{"points", primitive_.positions.count()}}));
        if (!field(json_, "indices").is_null()) {
            auto indices = open(json_, "indices", "SCALAR");
            if (!indices) return tl::unexpected(indices.error());
            primitive_.indices = std::move(*indices);
        }
        if (field(attributes, kJoints).is_null() || field(attributes, kWeights).is_null()) return {};
        auto joints = open(attributes, kJoints, "VEC4");
        if (!joints) return tl::unexpected(joints.error());
        auto weights = open(attributes, kWeights, "VEC4");
        if (!weights) return tl::unexpected(weights.error());
        if (joints->count() < primitive_.positions.count() || weights->count() < primitive_.positions.count())
            return refuse(say("gltf.few_joints"));
        primitive_.influence = {std::move(*joints), std::move(*weights)};
        return {};
    }

    /// One of the attributes that Draco packed, as the accessor that stands for it scales it.
    Result<double> ask(const Json& packed, const std::string& name, int components,
                       std::vector<DracoAttribute>& asked) {
        const auto id = whole(packed, name.c_str(), 0);
        if (!id) return tl::unexpected(id.error());
        asked.push_back({static_cast<int>(std::min<std::uint64_t>(*id, 0x7FFFFFFF)), components});
        const auto index = whole(field(json_, "attributes"), name.c_str(), 0);
        if (!index) return tl::unexpected(index.error());
        const Json& accessor = item(field(scene_, "accessors"), *index);
        const auto component = component_of(accessor);
        if (!component) return tl::unexpected(component.error());
        const Json& normalised = field(accessor, "normalized");
        return normalised.is_boolean() && normalised.get<bool>() ? divisor(*component) : 1.0;
    }

    Result<void> read_packed(const Json& packed) {
        const Json& attributes = field(packed, "attributes");
        if (field(attributes, "POSITION").is_null()) return refuse(say("draco.no_places"));
        std::vector<DracoAttribute> asked;
        std::vector<double> scales;
        std::vector<std::string> wanted{"POSITION"};
        if (!field(attributes, kJoints).is_null() && !field(attributes, kWeights).is_null())
            wanted.insert(wanted.end(), {kJoints, kWeights});
        for (const std::string& name : wanted) {
            const auto scale = ask(attributes, name, name == "POSITION" ? 3 : 4, asked);
            if (!scale) return tl::unexpected(scale.error());
            scales.push_back(*scale);
        }
        const auto view = whole(packed, "bufferView", 0);
        if (!view) return tl::unexpected(view.error());
        const auto mesh = draco_.open(buffers_, *view, asked);
        if (!mesh) return tl::unexpected(mesh.error());
        const auto over = [&](std::size_t i) {
            return Accessor((*mesh)->attributes[i], asked[i].components, scales[i]);
        };
        primitive_.topology = Topology::triangles;
        primitive_.positions = over(0);
        primitive_.packed_corners = (*mesh)->corners;
        if (asked.size() == 3) primitive_.influence = {over(1), over(2)};
        return {};
    }

    Result<void> read_morphs(std::span<const double> weights) {
        const Json& targets = field(json_, "targets");
        for (std::size_t i = 0; i < weights.size() && i < count_of(targets); ++i) {
            if (weights[i] == 0 || field(item(targets, i), "POSITION").is_null()) continue;
            auto offsets = open(item(targets, i), "POSITION", "VEC3");
            if (!offsets) return tl::unexpected(offsets.error());
            if (offsets->count() < primitive_.positions.count()) return refuse(say("gltf.short_morph"));
            primitive_.morphs.push_back({std::move(*offsets), weights[i]});
        }
        return {};
    }

    const Json& scene_;
    Buffers& buffers_;
    DracoMeshes& draco_;
    const Json& json_;
    Primitive primitive_;
};

}  // namespace

std::uint64_t Primitive::corners() const {
    if (!packed_corners.empty()) return packed_corners.size();
    return indices ? indices->count() : positions.count();
}

std::optional<std::uint64_t> Primitive::corner(std::uint64_t i) const {
    if (!packed_corners.empty()) return packed_corners[static_cast<std::size_t>(i)];
    if (!indices) return i;
    const auto point = static_cast<std::uint64_t>(indices->at(i, 0));
    // Graphics processors begin anew at the greatest value.
    if (point >= positions.count() && point == indices->greatest()) return {};
    return point;
}

std::uint64_t Primitive::effort() const {
    std::uint64_t sum = positions.effort() + (indices ? indices->effort() : 0);
    for (const Morph& morph : morphs) sum += morph.offsets.effort();
    return sum + (influence ? 2 * (influence->joints.effort() + influence->weights.effort()) : 0);
}

Vec3d Primitive::point(std::uint64_t point) const {
    Vec3d place = positions.vec3(point);
    for (const Morph& morph : morphs) place = place + morph.offsets.vec3(point) * morph.weight;
    return place;
}

std::optional<Affine> Primitive::skinned(std::uint64_t point, std::span<const Affine> pose) const {
    Affine sum{{Vec3d{}, Vec3d{}, Vec3d{}}, {}};
    double total = 0;
    const auto add = [&](std::uint64_t joint, double weight) {
        const Affine& map = pose[static_cast<std::size_t>(joint)];
        for (std::size_t row = 0; row < 3; ++row) sum.row[row] = sum.row[row] + map.row[row] * weight;
        sum.shift = sum.shift + map.shift * weight;
        total += weight;
    };
    if (!influence || pose.empty()) return {};
    for (int c = 0; c < 4; ++c) {
        const double weight = influence->weights.at(point, c), joint = influence->joints.at(point, c);
        if (weight == 0 || !std::isfinite(weight)) continue;
        if (!(joint >= 0 && joint < static_cast<double>(pose.size()))) return {};
        add(static_cast<std::uint64_t>(joint), weight);
    }
    if (total == 0) add(0, 1);  // as viewers do
    if (std::fabs(total - 1) > kWeightRounding) return sum;
    for (Vec3d& row : sum.row) row = row * (1 / total);
    sum.shift = sum.shift * (1 / total);
    return sum;
}

Result<std::optional<Primitive>> open_primitive(const Json& scene, Buffers& buffers, DracoMeshes& draco,
                                                const Json& primitive, std::span<const double> weights) {
    return PrimitiveReader(scene, buffers, draco, primitive).read(weights);
}

}  // namespace snug::gltf
