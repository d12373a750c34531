#include <algorithm>
#include <string_view>

#include "snug/formats/read.h"
#include "snug/formats/shape_text.h"

namespace snug {

Result<Mesh> read_shape(Bytes file) {
    constexpr std::size_t kLongest = 1 << 20;
    if (file.size() > kLongest) return fail(ErrorKind::input, say("shape.many"));
    const auto solids = parse_shape({reinterpret_cast<const char*>(file.data()), file.size()});
    if (!solids) return tl::unexpected(solids.error());
    Mesh mesh;
    for (const SimpleSolid& solid : *solids) add_solid(mesh, solid);
    mesh.read.in_mm = true;
    mesh.read.faces = mesh.triangles.size();
    return mesh;
}

}  // namespace snug
