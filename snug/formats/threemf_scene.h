#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "snug/formats/threemf_model.h"
#include "snug/formats/threemf_package.h"

namespace snug {

/// How much a 3MF's build places.
struct ThreeMfCount {
    std::uint64_t triangles = 0;
    std::uint64_t left_out = 0;  ///< triangles that ThreeMfObject::left_out counts
    std::uint64_t meshes = 0;
};

/// The models of a 3MF and what they place. Models are read when something names them; each is read once.
class ThreeMfScene {
  public:
    ThreeMfScene(ThreeMfPackage package, std::string root);

    /// Reads the root and every model that its build reaches. Fails (input) where one cannot be read, names
    /// what is not there, goes round in a circle, or repeats more than its limits.
    [[nodiscard]] Result<void> load();

    /// How much is placed as `role`: things or supports. load() first.
    [[nodiscard]] ThreeMfCount count(ThreeMfRole role) const;
    /// All of it in one mesh, mm, in the order of the build. load() first.
    [[nodiscard]] RawMesh placed(ThreeMfRole role) const;

  private:
    struct Child {
        std::size_t node;
        Affine place;
    };
    struct Node {
        const ThreeMfObject* object;
        ThreeMfRole role;  // with that of what it is a part of
        std::vector<Child> children;
        std::array<ThreeMfCount, 2> count;  // of things, of supports
        int height = 0;                     // components within components below it
        bool open = true;                   // being added: a circle where it is met again
    };
    using Key = std::tuple<std::string, std::int64_t, ThreeMfRole>;

    [[nodiscard]] Result<const ThreeMfModel*> model(const std::string& part);
    [[nodiscard]] Result<std::vector<ThreeMfUse>> build();
    [[nodiscard]] Result<std::size_t> add(const ThreeMfUse& use, const std::string& from, ThreeMfRole role,
                                          int depth);
    [[nodiscard]] Result<void> add_children(std::size_t node, const std::string& part, int depth);
    [[nodiscard]] Result<void> check_limits() const;
    void place(const Node& node, const Affine& at, ThreeMfRole role, RawMesh& mesh) const;

    ThreeMfPackage package_;
    std::string root_;
    std::map<std::string, ThreeMfModel> models_;
    std::map<Key, std::size_t> numbers_;
    std::vector<Node> nodes_;
    std::vector<Child> build_;
    ThreeMfTotals totals_;
    std::uint64_t triangles_ = 0;  // that the models hold
};

}  // namespace snug
