#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "snug/mesh/mesh.h"
#include "snug/object/object.h"
#include "snug/space/item.h"

namespace snug {

/// The surfaces of all items as one, for pictures and checks that ask for no item of its own. Of one item it
/// is the object's mesh where that lies; the objects outlive it.
class PlacedMesh {
  public:
    PlacedMesh(std::span<const Object> objects, const std::vector<Item>& items);
    PlacedMesh(const PlacedMesh&) = delete;
    PlacedMesh& operator=(const PlacedMesh&) = delete;

    [[nodiscard]] const Mesh& mesh() const { return together_ ? *together_ : *only_; }
    [[nodiscard]] const Placement& placement() const { return placement_; }
    /// Whether all of them are known as meshes; and whether each is closed.
    [[nodiscard]] bool whole() const { return whole_; }
    [[nodiscard]] bool closed() const { return closed_; }

  private:
    const Mesh* only_ = nullptr;
    std::optional<Mesh> together_;  ///< in design coordinates
    Placement placement_;
    bool whole_ = true, closed_ = true;
};

/// One for each of so many layers, the lowest first.
[[nodiscard]] std::deque<PlacedMesh> placed_layers(std::span<const Object> objects,
                                                   const std::vector<Item>& items, int layers);

}  // namespace snug
