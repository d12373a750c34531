#include "cli/assimp_scene.h"

#include <algorithm>
#include <array>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cstdint>
#include <memory>
#include <optional>
#include <regex>
#include <string_view>
#include <utility>
#include <vector>
#include <zip.h>

#include <fmt/core.h>

#include "snug/mesh/raw_mesh.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kMmPerMetre = 1000;  // the unit of glTF
constexpr std::size_t kMostTriangles = 400'000'000;
constexpr std::size_t kMostDepth = 256;  // of nodes within nodes
constexpr zip_uint64_t kMostHead = 1 << 16;

/// Only files beside the scene are read.
class OneFolder : public Assimp::DefaultIOSystem {
  public:
    explicit OneFolder(fs::path folder) : folder_(std::move(folder)) {}

    bool Exists(const char* file) const override {
        return inside(file) && Assimp::DefaultIOSystem::Exists(file);
    }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        return inside(file) ? Assimp::DefaultIOSystem::Open(file, mode) : nullptr;
    }

  private:
    [[nodiscard]] bool inside(const char* file) const {
        std::error_code error;
        const fs::path real = fs::weakly_canonical(file, error);
        if (error) return false;
        const fs::path root = fs::weakly_canonical(folder_, error);
        return !error &&
               std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
    }

    fs::path folder_;
};

/// An affine map; points are columns.
struct Affine {
    std::array<Vec3d, 3> row{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    Vec3d shift;

    [[nodiscard]] Vec3d turned(Vec3d p) const { return {dot(row[0], p), dot(row[1], p), dot(row[2], p)}; }
    [[nodiscard]] Vec3d operator()(Vec3d p) const { return turned(p) + shift; }
    [[nodiscard]] Affine operator*(const Affine& inner) const {
        Affine result;
        for (int column = 0; column < 3; ++column) {
            const Vec3d of{inner.row[0][column], inner.row[1][column], inner.row[2][column]};
            const Vec3d at = turned(of);
            for (int i = 0; i < 3; ++i) result.row[static_cast<std::size_t>(i)][column] = at[i];
        }
        result.shift = (*this)(inner.shift);
        return result;
    }
    [[nodiscard]] bool mirrors() const { return dot(cross(row[0], row[1]), row[2]) < 0; }
};

Affine affine_of(const aiMatrix4x4& m) {
    const auto d = [](ai_real value) { return static_cast<double>(value); };
    return {{Vec3d{d(m.a1), d(m.a2), d(m.a3)}, Vec3d{d(m.b1), d(m.b2), d(m.b3)},
             Vec3d{d(m.c1), d(m.c2), d(m.c3)}},
            {d(m.a4), d(m.b4), d(m.c4)}};
}

/// Gathers what a scene's nodes place.
class Gatherer {
  public:
    explicit Gatherer(const aiScene& scene) : scene_(scene) {}

    Result<Mesh> take(double mm_per_unit) && {
        Affine to_mm;
        for (int i = 0; i < 3; ++i) to_mm.row[static_cast<std::size_t>(i)][i] = mm_per_unit;
        if (scene_.mRootNode == nullptr || !visit(*scene_.mRootNode, to_mm, 0))
            return fail(ErrorKind::input, wrong_);
        if (raw_.triangles.empty()) return fail(ErrorKind::input, "there are no triangles in it");
        return finish(std::move(raw_));
    }

  private:
    bool visit(const aiNode& node, const Affine& parent, std::size_t depth) {
        if (depth > kMostDepth) return refuse("its nodes lie too deep within each other");
        const Affine here = parent * affine_of(node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            if (node.mMeshes[i] >= scene_.mNumMeshes) return refuse("a node names a mesh that is not there");
            if (!add(*scene_.mMeshes[node.mMeshes[i]], here)) return false;
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            if (!visit(*node.mChildren[i], here, depth + 1)) return false;
        return true;
    }

    bool add(const aiMesh& mesh, const Affine& place) {
        const std::size_t first = raw_.vertices.size();
        if (raw_.triangles.size() + mesh.mNumFaces > kMostTriangles)
            return refuse("its nodes repeat more triangles than any scan has");
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D& p = mesh.mVertices[v];
            raw_.vertices.push_back(
                place({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)}));
        }
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) continue;  // points and lines
            Triangle triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                if (face.mIndices[i] >= mesh.mNumVertices)
                    return refuse("a triangle wants a vertex that is not there");
                triangle[i] = static_cast<std::uint32_t>(first + face.mIndices[i]);
            }
            // A mirroring node turns every triangle inside out; the other way round they face outward again.
            if (place.mirrors()) std::swap(triangle[1], triangle[2]);
            raw_.triangles.push_back(triangle);
        }
        return true;
    }

    bool refuse(const std::string& why) {
        wrong_ = why;
        return false;
    }

    const aiScene& scene_;
    RawMesh raw_;
    std::string wrong_ = "there is nothing in it";
};

/// The beginning of a 3MF's model, which names the unit.
std::optional<std::string> head_of_model(Bytes file) {
    struct Discard {
        void operator()(zip_t* archive) const { zip_discard(archive); }
        void operator()(zip_file_t* member) const { zip_fclose(member); }
    };
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(file.data(), file.size(), 0, &error);
    if (source == nullptr) return {};
    const std::unique_ptr<zip_t, Discard> archive(zip_open_from_source(source, ZIP_RDONLY, &error));
    if (!archive) {
        zip_source_free(source);
        return {};
    }
    const zip_int64_t index = zip_name_locate(archive.get(), "3D/3dmodel.model", ZIP_FL_NOCASE);
    if (index < 0) return {};
    const std::unique_ptr<zip_file_t, Discard> member(
        zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(index), 0));
    std::string head(kMostHead, '\0');
    const zip_int64_t count = member ? zip_fread(member.get(), head.data(), head.size()) : -1;
    if (count < 0) return {};
    head.resize(static_cast<std::size_t>(count));
    return head;
}

Result<double> mm_per_3mf_unit(Bytes file) {
    static constexpr std::array<std::pair<std::string_view, double>, 6> kUnits = {{{"micron", 0.001},
                                                                                   {"millimeter", 1},
                                                                                   {"centimeter", 10},
                                                                                   {"inch", 25.4},
                                                                                   {"foot", 304.8},
                                                                                   {"meter", 1000}}};
    const auto head = head_of_model(file);
    if (!head) return fail(ErrorKind::input, "this is no 3MF file: there is no 3D/3dmodel.model in it");
    const std::size_t model = head->find("model ");
    const std::string tag =
        model == std::string::npos ? "" : head->substr(model, head->find('>', model) - model);
    static const std::regex kUnit("\\sunit\\s*=\\s*[\"'](\\w+)[\"']");
    std::smatch match;
    if (!std::regex_search(tag, match, kUnit)) return 1.0;
    const auto known = std::find_if(kUnits.begin(), kUnits.end(),
                                    [&](const auto& unit) { return unit.first == match[1].str(); });
    if (known == kUnits.end())
        return fail(ErrorKind::input, "its unit \"" + match[1].str() + "\" is none that 3MF knows");
    return known->second;
}

}  // namespace

Result<Mesh> read_scene_here(Bytes file, SceneFormat format, const fs::path& path) {
    double mm_per_unit = kMmPerMetre;
    if (format == SceneFormat::threemf) {
        const auto unit = mm_per_3mf_unit(file);
        if (!unit) return tl::unexpected(unit.error());
        mm_per_unit = *unit;
    }
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_PP_FD_REMOVE, false);
    const aiScene* scene = nullptr;
    if (format == SceneFormat::gltf) {
        importer.SetIOHandler(new OneFolder(path.parent_path().empty() ? "." : path.parent_path()));
        scene = importer.ReadFile(path.string(), aiProcess_Triangulate);
    } else {
        scene = importer.ReadFileFromMemory(file.data(), file.size(), aiProcess_Triangulate,
                                            format == SceneFormat::glb ? "glb" : "3mf");
    }
    if (scene == nullptr)
        return fail(ErrorKind::input, fmt::format("it cannot be read ({})", importer.GetErrorString()));
    return Gatherer(*scene).take(mm_per_unit);
}

}  // namespace snug::cli
