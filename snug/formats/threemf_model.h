#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/affine.h"
#include "snug/mesh/raw_mesh.h"

namespace snug {

/// Where a model puts an object: an item of its build, or a component of another object.
struct ThreeMfUse {
    std::string part;         ///< the model that has the object (ThreeMfPackage::part_name); empty: this one
    std::int64_t object = 0;  ///< its id there
    Affine place;             ///< mm to mm
};

/// What an object is for. Each includes the ones before it: a part of a support is no part of the thing.
enum class ThreeMfRole { thing, support, other };

struct ThreeMfObject {
    ThreeMfRole role = ThreeMfRole::thing;
    RawMesh mesh;              ///< mm; every vertex is a number and used, every index is in range
    std::size_t left_out = 0;  ///< triangles with corners that are not there or no numbers
    std::vector<ThreeMfUse> components;
    std::string unread;  ///< code of the shape that it has instead, which Snug does not read; or empty
};

/// One model part of a 3MF.
struct ThreeMfModel {
    std::map<std::int64_t, ThreeMfObject> objects;  ///< by id
    std::vector<ThreeMfUse> build;
};

/// What all models of a file have together.
struct ThreeMfTotals {
    static constexpr std::uint64_t kMostUses = 1'000'000;  ///< items and components
    static constexpr std::uint64_t kMostObjects = 200'000;
    std::uint64_t uses = 0, objects = 0;
};

/// Reads a model (3MF core specification 1.4, production extension 1.1), lengths in mm. What is about looks
/// is passed over. `totals` grow by what it has, and stop it where they are too high. Errors (input) name the
/// line.
[[nodiscard]] Result<ThreeMfModel> read_3mf_model(Bytes xml, ThreeMfTotals& totals);

/// The sentence of a file that has too much of something.
[[nodiscard]] Message too_many_in_3mf(const char* code, std::uint64_t most);

}  // namespace snug
