#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// The places where a cloud's points lie, each once: without this, points in the same place would all be
/// looked at by each of them. In the order of x, y, z.
class CloudPlaces {
  public:
    /// Of the nearest() that can be asked for.
    static constexpr std::size_t kMostNeighbours = 24;
    struct Neighbours {
        std::size_t count = 0;
        std::array<std::uint32_t, kMostNeighbours> place{};
        std::array<double, kMostNeighbours> squared{};  ///< distances, in this order
    };

    explicit CloudPlaces(const Mesh& cloud);
    ~CloudPlaces();
    CloudPlaces(const CloudPlaces&) = delete;
    CloudPlaces& operator=(const CloudPlaces&) = delete;

    [[nodiscard]] std::size_t size() const { return at_.size(); }
    [[nodiscard]] Vec3d position(std::size_t place) const { return vec_cast<double>(at_[place]); }
    [[nodiscard]] std::uint32_t of_vertex(std::size_t vertex) const { return of_vertex_[vertex]; }
    /// The first vertex that lies there.
    [[nodiscard]] std::uint32_t vertex_of(std::size_t place) const { return vertex_[place]; }

    /// At most `count` nearest other places. Which of several at the same distance is left open.
    [[nodiscard]] Neighbours nearest(std::size_t place, std::size_t count) const;

  private:
    struct Tree;
    std::vector<Vec3f> at_;
    std::vector<std::uint32_t> vertex_;
    std::vector<std::uint32_t> of_vertex_;
    std::unique_ptr<Tree> tree_;
};

}  // namespace snug
