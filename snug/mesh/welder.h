#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "snug/mesh/raw_mesh.h"

namespace snug {

/// Joins the corners of triangles that have equal bits (-0 = 0), numbering vertices in the order of their
/// first appearance. Open addressing; the table holds indices into the vertices. Triangles come in batches,
/// so that the waits for a large table's memory overlap.
template <class T>
class Welder {
  public:
    using Corners = std::array<Vec3<T>, 3>;
    static constexpr std::size_t kBatch = 32;  ///< triangles at most

    /// `triangles`: about how many will come.
    Welder(RawMeshOf<T>& mesh, std::size_t triangles) : mesh_(mesh) {
        std::size_t size = 64;
        while (size < triangles + triangles / 2) size *= 2;
        table_.assign(size, kEmpty);
    }

    /// Appends triangles and those of their vertices that are new to the mesh.
    void append(std::span<const Corners> batch) {
        assert(batch.size() <= kBatch);
        while ((mesh_.vertices.size() + 3 * batch.size()) * 2 > table_.size()) grow();
        for (std::size_t t = 0; t < batch.size(); ++t) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                keys_[t][corner] = key_of(batch[t][corner]);
                __builtin_prefetch(&table_[start(keys_[t][corner])]);
            }
        }
        for (std::size_t t = 0; t < batch.size(); ++t)
            for (const Key& key : keys_[t])
                if (const std::uint32_t v = table_[start(key)]; v != kEmpty)
                    __builtin_prefetch(&mesh_.vertices[v]);
        for (std::size_t t = 0; t < batch.size(); ++t)
            mesh_.triangles.push_back({number(keys_[t][0]), number(keys_[t][1]), number(keys_[t][2])});
    }

  private:
    static constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();

    struct Key {
        Vec3<T> point;
        std::uint64_t hash;
    };

    static Key key_of(Vec3<T> p) {
        p = p + Vec3<T>{};  // -0 + 0 = 0
        std::uint64_t hash = 0;
        for (const T value : {p.x, p.y, p.z}) {
            std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t> bits;
            std::memcpy(&bits, &value, sizeof bits);
            // Neighbouring vertices are alike in most bits, so every bit must reach the low ones.
            hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return {p, hash};
    }

    std::uint32_t number(const Key& key) {
        std::uint32_t& slot = find(key);
        if (slot == kEmpty) {
            slot = static_cast<std::uint32_t>(mesh_.vertices.size());
            mesh_.vertices.push_back(key.point);
        }
        return slot;
    }

    [[nodiscard]] std::size_t start(const Key& key) const {
        return static_cast<std::size_t>(key.hash) & (table_.size() - 1);
    }

    std::uint32_t& find(const Key& key) {
        std::size_t at = start(key);
        while (table_[at] != kEmpty &&
               std::memcmp(&mesh_.vertices[table_[at]], &key.point, sizeof key.point) != 0)
            at = (at + 1) & (table_.size() - 1);
        return table_[at];
    }

    void grow() {
        table_.assign(table_.size() * 2, kEmpty);
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
            find(key_of(mesh_.vertices[v])) = static_cast<std::uint32_t>(v);
    }

    RawMeshOf<T>& mesh_;
    std::array<std::array<Key, 3>, kBatch> keys_{};  // of the batch at hand
    std::vector<std::uint32_t> table_;
};

}  // namespace snug
