#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/formats/read.h"

namespace snug {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
[[nodiscard]] std::size_t size_of(PlyType type);
[[nodiscard]] bool is_integer(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;    ///< of the value, or of a list's items
    std::optional<PlyType> count_type;  ///< set for lists
};

/// Which properties of a face hold its corners: a list, or several numbers one after the other.
struct PlyCorners {
    std::size_t first = 0;
    std::size_t count = 0;  ///< of the properties; 0 where there are none
};

struct PlyElement {
    std::string name;  ///< as the format has it ("vertex", "face") where the file has another word for it
    std::uint64_t count = 0;  ///< fits the file, unless there are no properties
    std::vector<PlyProperty> properties;
    PlyCorners corners;  ///< of elements "face" and "tristrips"

    /// The place of a property, or properties.size().
    [[nodiscard]] std::size_t find(std::string_view property) const;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< where the data begins
    std::size_t lines = 0;  ///< of the header
};

/// Fails with the line that is wrong; counts that the file is too short for are refused. Lines that begin
/// with an unknown word are passed over.
[[nodiscard]] Result<PlyHeader> read_ply_header(Bytes file);
/// The same of a file's beginning, as much of it as kLongestPlyHeader or all, and the size of the whole.
[[nodiscard]] Result<PlyHeader> read_ply_header(Bytes beginning, std::uint64_t file_size);
inline constexpr std::size_t kLongestPlyHeader = 1 << 20;

/// Whether float holds the coordinates of all vertices without rounding.
[[nodiscard]] bool has_float_vertices(const PlyHeader& header);

/// What is wrong with a face (numbered from 0, called `noun`) that names a vertex which is not there.
[[nodiscard]] Error ply_wrong_index(const Message& noun, std::uint64_t number, std::int64_t vertex,
                                    std::uint64_t vertices);

}  // namespace snug
