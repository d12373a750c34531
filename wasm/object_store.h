#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/result.h"
#include "snug/check/surface_distance.h"
#include "snug/design/project.h"
#include "snug/mesh/mesh.h"
#include "snug/object/object.h"

namespace snug::wasm {

/// The objects of a session as their files have them, and prepared with the choices that were last asked
/// for. Whoever loads one gives it a number, by which it is asked for.
class ObjectStore {
  public:
    struct Entry {
        int number = 0;
        Mesh read;                                    ///< as the file has it, in its own unit
        Box3d box;                                    ///< of it
        std::optional<SurfaceDistance> surface = {};  ///< of the prepared object, once it was asked for
        bool prepared = false;
    };

    /// One more, under a number of its own, prepared as the design says. Where the size is implausible and no
    /// unit is chosen it is kept unprepared, and the error says why; after other errors there is none.
    [[nodiscard]] std::optional<Error> load(int number, Mesh read, const Design& design);
    /// Forgets all others.
    void keep(std::span<const int> numbers);

    /// Prepares one as the design says; none for a number that there is not.
    [[nodiscard]] std::optional<Error> prepare(int number, const Design& design);
    /// Lays a project's objects side by side, as objects() has them, each prepared.
    [[nodiscard]] std::optional<Error> lay_out(std::span<const int> numbers, const Project& project);
    [[nodiscard]] std::span<Object> objects() { return std::span(objects_).first(laid_out_); }

    /// None for a number that there is not.
    [[nodiscard]] const Entry* find(int number) const;
    [[nodiscard]] const Object& object_of(const Entry& entry) const;
    /// Of one of objects(). Fails only when cancelled.
    [[nodiscard]] Result<const SurfaceDistance*> surface_of(std::size_t object);

    /// Another one whenever an object, or which of them are laid out, changed.
    [[nodiscard]] std::uint64_t edition() const { return edition_; }

  private:
    [[nodiscard]] std::optional<std::size_t> place_of(int number) const;
    [[nodiscard]] std::optional<Error> prepare_at(std::size_t place, const Design& design);

    std::vector<Entry> entries_;
    std::vector<Object> objects_;  ///< of entries_, one for each
    std::size_t laid_out_ = 0;
    std::uint64_t edition_ = 0;
};

/// No unit is known or chosen, and there is a size that one would make plausible.
[[nodiscard]] bool asks_for_unit(const ObjectStore::Entry& entry, const Design& design);
/// What can be said of an object that has no size in mm yet.
[[nodiscard]] Object unscaled(const Mesh& mesh);

}  // namespace snug::wasm
