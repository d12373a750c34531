#include "snug/formats/threemf_read.h"

#include <utility>

#include "snug/formats/threemf_package.h"
#include "snug/formats/threemf_scene.h"

namespace snug {

bool is_3mf(Bytes file, const SceneTools& tools) {
    if (!is_zip(file)) return false;
    auto package = ThreeMfPackage::open(file, tools);
    if (!package) return false;
    const auto root = package->root();
    return root && root->has_value();
}

Result<Mesh> read_3mf(Bytes file, const SceneTools& tools) {
    auto package = ThreeMfPackage::open(file, tools);
    if (!package) return tl::unexpected(package.error());
    const auto root = package->root();
    if (!root) return tl::unexpected(root.error());
    if (!*root) return fail(ErrorKind::input, say("threemf.no_3mf"));
    ThreeMfScene scene(std::move(*package), **root);
    if (auto done = scene.load(); !done) return tl::unexpected(done.error());

    const auto has_faces = [&](ThreeMfRole role) { return scene.count(role).meshes > 0; };
    const ThreeMfRole role = has_faces(ThreeMfRole::thing) ? ThreeMfRole::thing : ThreeMfRole::support;
    const ThreeMfCount count = scene.count(role);
    const std::uint64_t faces = count.triangles + count.left_out;
    if (faces == 0) return fail(ErrorKind::input, say("threemf.no_triangles"));
    if (count.left_out > count.triangles)
        return fail(ErrorKind::input,
                    say("threemf.most_left_out", {{"left_out", count.left_out}, {"faces", faces}}));
    auto mesh = finish(scene.placed(role));
    if (!mesh) return mesh;
    mesh->read.in_mm = true;
    mesh->read.faces = static_cast<std::size_t>(faces);
    mesh->read.left_out_faces = static_cast<std::size_t>(count.left_out);
    return mesh;
}

}  // namespace snug
