#include "snug/formats/gltf_read.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "snug/formats/gltf_buffers.h"
#include "snug/formats/gltf_container.h"
#include "snug/formats/gltf_draco.h"
#include "snug/formats/gltf_extensions.h"
#include "snug/formats/gltf_gather.h"
#include "snug/formats/gltf_nodes.h"
#include "snug/formats/gltf_primitive.h"
#include "snug/formats/gltf_skin.h"

namespace snug {
namespace gltf {
namespace {

constexpr double kMmPerMetre = 1000;  // the unit of glTF
constexpr std::uint64_t kStepsPerPrimitive = 512, kStepsPerShape = 8;
constexpr std::uint64_t kBytesPerDracoByte = 4;  // as if not packed

/// Default weights of a node's morph targets: its own, or else the mesh's.
Result<std::vector<double>> morph_weights(const Json& node, const Json& mesh) {
    const Json& own = field(node, "weights");
    const Json& from = own.is_array() ? node : mesh;
    std::vector<double> weights(static_cast<std::size_t>(count_of(field(from, "weights"))));
    if (const auto read = numbers(from, "weights", weights); !read) return tl::unexpected(read.error());
    return weights;
}

class SceneReader {
  public:
    SceneReader(const Container& file, const SceneTools& tools, std::uint64_t bytes, Nodes nodes)
        : scene_(file.json),
          buffers_(file, tools, bytes),
          draco_(file.json, tools),
          nodes_(std::move(nodes)),
          skins_(file.json, buffers_, nodes_) {}

    Result<Mesh> read() {
        const auto shown = nodes_.shown();
        if (!shown) return tl::unexpected(shown.error());
        for (const std::uint64_t node : *shown)
            if (const auto done = show(node); !done) return tl::unexpected(done.error());
        return std::move(gatherer_).take();
    }

  private:
    Result<void> show(std::uint64_t index) {
        const Json& node = nodes_.json(index);
        if (field(node, "mesh").is_null()) return {};
        const auto which = whole(node, "mesh", 0);
        if (!which) return tl::unexpected(which.error());
        const Json& mesh = item(field(scene_, "meshes"), *which);
        if (!mesh.is_object()) return refuse(say("gltf.no_mesh", {{"mesh", *which}}));
        // Each node that shows a mesh reads all its weights, and each primitive those of its shapes.
        const std::uint64_t shapes =
            std::max(count_of(field(node, "weights")), count_of(field(mesh, "weights")));
        if (const auto fair = buffers_.spend(kStepsPerShape * shapes); !fair) return fair;
        const auto weights = morph_weights(node, mesh);
        if (!weights) return tl::unexpected(weights.error());
        const std::vector<Affine>* pose = nullptr;
        if (!field(node, "skin").is_null()) {
            const auto skin = whole(node, "skin", 0);
            if (!skin) return tl::unexpected(skin.error());
            const auto found = skins_.pose(*skin);
            if (!found) return tl::unexpected(found.error());
            pose = *found;
        }
        const Json& primitives = field(mesh, "primitives");
        for (std::uint64_t i = 0; i < count_of(primitives); ++i) {
            const Json& json = item(primitives, i);
            const std::uint64_t mixed = std::min(shapes, count_of(field(json, "targets")));
            if (const auto fair = buffers_.spend(kStepsPerPrimitive + kStepsPerShape * mixed); !fair)
                return fair;
            const auto primitive = open_primitive(scene_, buffers_, draco_, json, *weights);
            if (!primitive) return tl::unexpected(primitive.error());
            if (!primitive->has_value() || (*primitive)->corners() == 0) continue;
            if (const auto done = place(index, **primitive, pose); !done) return done;
        }
        return {};
    }

    /// What hangs on joints stands where they do, wherever its node is.
    Result<void> place(std::uint64_t node, const Primitive& primitive, const std::vector<Affine>* pose) {
        const Affine to_mm = scaling(kMmPerMetre);
        if (pose != nullptr && primitive.influence) {
            const auto fair = gatherer_.announce(primitive, 1, 0, bytes_behind());
            return fair ? gatherer_.add(primitive, to_mm, pose) : fair;
        }
        const auto world = nodes_.world(node);
        if (!world) return tl::unexpected(world.error());
        const auto instances = Instances::open(scene_, buffers_, nodes_.json(node));
        if (!instances) return tl::unexpected(instances.error());
        if (const auto fair =
                gatherer_.announce(primitive, instances->count(), instances->effort(), bytes_behind());
            !fair)
            return fair;
        for (std::uint64_t i = 0; i < instances->count(); ++i)
            if (const auto done = gatherer_.add(primitive, to_mm * *world * instances->at(i), nullptr); !done)
                return done;
        return {};
    }

    [[nodiscard]] std::uint64_t bytes_behind() const {
        return (draco_.used() ? kBytesPerDracoByte : 1) * buffers_.bytes_read();
    }

    const Json& scene_;
    Buffers buffers_;
    DracoMeshes draco_;
    Nodes nodes_;
    Skins skins_;
    Gatherer gatherer_;
};

}  // namespace
}  // namespace gltf

Result<Mesh> read_gltf(Bytes file, const SceneTools& tools) {
    const auto container = gltf::open_container(file);
    if (!container) return tl::unexpected(container.error());
    if (const auto known = gltf::check_extensions(container->json); !known)
        return tl::unexpected(known.error());
    auto nodes = gltf::Nodes::open(container->json);
    if (!nodes) return tl::unexpected(nodes.error());
    return gltf::SceneReader(*container, tools, file.size(), std::move(*nodes)).read();
}

}  // namespace snug
