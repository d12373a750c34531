#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "snug/base/text.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/read.h"
#include "snug/mesh/text_scan.h"

namespace snug {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kFacet = 50;

/// Joins vertices with equal bits (-0 = 0), numbering them in the order of their first appearance. Open
/// addressing; the table holds indices into the vertices.
class Welder {
  public:
    Welder(RawMesh& mesh, std::size_t corners) : mesh_(mesh) {
        std::size_t size = 64;
        while (size < corners / 2) size *= 2;
        table_.assign(size, kEmpty);
    }

    std::uint32_t number(Vec3d p) {
        p = p + Vec3d{};  // -0 + 0 = 0
        if (mesh_.vertices.size() * 2 > table_.size()) grow();
        std::uint32_t& slot = find(p);
        if (slot == kEmpty) {
            slot = static_cast<std::uint32_t>(mesh_.vertices.size());
            mesh_.vertices.push_back(p);
        }
        return slot;
    }

  private:
    static constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();

    static std::uint64_t mixed(std::uint64_t hash, double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        return hash ^ (hash >> 32);
    }

    std::uint32_t& find(Vec3d p) {
        const std::size_t mask = table_.size() - 1;
        std::size_t at = static_cast<std::size_t>(mixed(mixed(mixed(0, p.x), p.y), p.z)) & mask;
        while (table_[at] != kEmpty && std::memcmp(&mesh_.vertices[table_[at]], &p, sizeof p) != 0)
            at = (at + 1) & mask;
        return table_[at];
    }

    void grow() {
        table_.assign(table_.size() * 2, kEmpty);
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
            find(mesh_.vertices[v]) = static_cast<std::uint32_t>(v);
    }

    RawMesh& mesh_;
    std::vector<std::uint32_t> table_;
};

std::uint32_t read_u32(const std::byte* at) {
    return std::to_integer<std::uint32_t>(at[0]) | std::to_integer<std::uint32_t>(at[1]) << 8 |
           std::to_integer<std::uint32_t>(at[2]) << 16 | std::to_integer<std::uint32_t>(at[3]) << 24;
}

double read_f32(const std::byte* at) {
    const std::uint32_t bits = read_u32(at);
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

Result<Mesh> read_binary(Bytes file) {
    if (file.size() < kHeader)
        return fail(ErrorKind::input, "the file is cut off: a binary STL has at least 84 bytes, this one " +
                                          grouped(file.size()) + "; copy or export it again");
    const std::size_t count = read_u32(file.data() + 80);
    const std::size_t held = (file.size() - kHeader) / kFacet;
    if (held < count)
        return fail(ErrorKind::input, "the file is cut off: it says " +
                                          counted(count, "triangle", "triangles") + " but holds " +
                                          grouped(held) + "; copy or export it again");
    RawMesh mesh;
    mesh.triangles.reserve(count);
    mesh.vertices.reserve(count / 2 + 3);
    Welder welder(mesh, count * 3);
    for (std::size_t t = 0; t < count; ++t) {
        const std::byte* corner = file.data() + kHeader + t * kFacet + 12;
        Triangle triangle{};
        for (std::uint32_t& v : triangle) {
            v = welder.number({read_f32(corner), read_f32(corner + 4), read_f32(corner + 8)});
            corner += 12;
        }
        mesh.triangles.push_back(triangle);
    }
    return finish(std::move(mesh));
}

Result<Mesh> read_ascii(Bytes file) {
    RawMesh mesh;
    Welder welder(mesh, file.size() / 40);
    TextScan text(file);
    std::array<std::uint32_t, 3> corners{};
    std::size_t corner = 0;
    for (; !text.at_end(); text.next_line()) {
        const std::string_view word = text.word('\0');
        if (same_word(word, "outer")) {
            corner = 0;
        } else if (same_word(word, "vertex")) {
            double p[3];
            for (double& value : p) {
                const std::string_view shown = text.word('\0');
                if (!to_number(shown, value))
                    return fail(ErrorKind::input,
                                text.place() + "a vertex needs three numbers, not " + quoted(shown));
            }
            if (corner == 3)
                return fail(ErrorKind::input, text.place() + "a facet has more than three vertices");
            corners[corner++] = welder.number({p[0], p[1], p[2]});
        } else if (same_word(word, "endloop")) {
            if (corner != 3)
                return fail(ErrorKind::input,
                            text.place() + "a facet has " + std::to_string(corner) + " vertices");
            mesh.triangles.push_back(corners);
        } else if (!(word.empty() || same_word(word, "solid") || same_word(word, "facet") ||
                     same_word(word, "endfacet") || same_word(word, "endsolid"))) {
            return fail(ErrorKind::input, text.place() + quoted(word) + " does not belong into an STL file");
        }
    }
    if (corner != 0 && corner != 3)
        return fail(ErrorKind::input, "the file is cut off within its last facet");
    return finish(std::move(mesh));
}

bool starts_with_solid(Bytes file) {
    TextScan text(file.first(std::min<std::size_t>(file.size(), 256)));
    return same_word(text.word_anywhere('\0'), "solid");
}

/// Programs write "solid" at the start of binary files too: what follows the first line decides.
bool looks_ascii(Bytes file) {
    if (!starts_with_solid(file)) return false;
    TextScan text(file.first(std::min<std::size_t>(file.size(), 4096)));
    text.next_line();
    const std::string_view next = text.word_anywhere('\0');
    return next.empty() || same_word(next, "facet") || same_word(next, "endsolid");
}

}  // namespace

Result<Mesh> read_stl(Bytes file) {
    const bool exact_binary = file.size() >= kHeader &&
                              (file.size() - kHeader) / kFacet == read_u32(file.data() + 80) &&
                              (file.size() - kHeader) % kFacet == 0;
    return !exact_binary && looks_ascii(file) ? read_ascii(file) : read_binary(file);
}

}  // namespace snug
