#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/mesh/mesh.h"

// Readers for the mesh formats that scanners and modellers write. They take the bytes of a whole file and
// give a mesh in the file's own unit, or an Error of kind `input` whose sentence names the place (line or
// byte) and what is wrong there. Bytes are hostile until checked: every count against the size of the file
// before any memory is asked for, every index, every coordinate for being finite. Nothing depends on the
// locale. What is no face and no place is left out and counted (ReadNotes); a file of which less than half
// would remain is refused.

namespace snug {

enum class MeshFormat { stl, obj, ply, off, shape };

/// Binary or ASCII, told apart by the size that the triangle count asks for, then by the first words.
/// Vertices are welded by bits (-0 = 0), since the format has no shared ones. Several solids in one file are
/// one mesh.
[[nodiscard]] Result<Mesh> read_stl(Bytes file);

/// Wavefront OBJ: v and f (faces of fewer than three corners are left out); polygons, negative and v/vt/vn
/// indices, continued lines; groups and materials ignored.
[[nodiscard]] Result<Mesh> read_obj(Bytes file);

/// ASCII or binary of either byte order; any further properties and elements are skipped; faces as
/// vertex_indices or what is clearly the same under another name, of any integer type, polygons and triangle
/// strips.
[[nodiscard]] Result<Mesh> read_ply(Bytes file);

/// OFF and its relatives COFF, NOFF, CNOFF, STOFF in ASCII, line by line or as numbers in a row; colours and
/// comments skipped.
[[nodiscard]] Result<Mesh> read_off(Bytes file);

/// An object from measurements, as shape_text.h has it, in mm: closed parts, whose volumes count twice where
/// they overlap.
[[nodiscard]] Result<Mesh> read_shape(Bytes file);

/// What to do with a file of a kind that is known and not read here, such as STEP; none for any other. The
/// first bytes suffice.
[[nodiscard]] std::optional<Error> foreign_format(Bytes beginning);

/// Which of the formats this is, by content first and by the name's ending second.
[[nodiscard]] Result<MeshFormat> mesh_format(Bytes file, std::string_view name);

/// mesh_format, then its reader; text in UTF-16 is decoded before.
[[nodiscard]] Result<Mesh> read_mesh(Bytes file, std::string_view name);

}  // namespace snug
