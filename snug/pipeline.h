#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/bearing.h"
#include "snug/check/fit_report.h"
#include "snug/check/gap.h"
#include "snug/design/design.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foam_pair.h"
#include "snug/foam/notches.h"
#include "snug/mesh/measure.h"
#include "snug/mesh/mesh.h"
#include "snug/object/clean_object.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/case_space.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

// The whole method, from a mesh to two foams (Fukusato and Kita, Computational Design and Fabrication of
// Protective Foam, 2025):
//
//   mesh in the file's unit --prepare--> object in mm, measured, its holes spanned
//   object + design ----------pack----> placement -> depth map -> block map -> foam pair, report and findings
//   packing ------------------gaps----> how far the cut space exceeds the object (sampled, slower)
//   packing ----------------bearing---> what the object lies on (sampled, slower)
//
// snug/outputs.h turns a packing into files.

namespace snug {

/// What is known of an object. Of a cloud of points, and of a mesh that was read in pieces, it is not known
/// whether it is closed, its volume, its parts, and gaps and undercuts; foams are exact all the same.
enum class ObjectKind { mesh, cloud, streamed };

/// An object ready to be packed any number of times.
struct Object {
    ObjectKind kind = ObjectKind::mesh;
    std::size_t read_vertices = 0;
    std::size_t read_triangles = 0;
    /// In millimetres; with its caps if the design asks for them. Of another kind: a closed stand-in around
    /// the object (shell.h), to look at and to search with.
    Mesh mesh;
    MeshMeasure measure;  ///< of the mesh as it was read, in millimetres; of another kind the bounds alone
    Mesh hole_spans;      ///< what would span the holes; empty where they are capped or there are none
    bool capped = false;
    std::optional<PreparedSurface> surface;  ///< of `mesh`, for many packings (see prepare_for_many)
    Mesh cloud;                              ///< of kind cloud: its points in millimetres
    std::vector<float> point_radius;         ///< of each of them, in millimetres
    CleanReport clean;                       ///< what the design had taken away
    std::vector<PartShare> parts;            ///< of the mesh as it was read, numbered as `--drop` takes them
};

/// Milliseconds that each stage of the method took; never part of a comparison.
struct Timing {
    double read = 0, depth_map = 0, block_map = 0, foam_pair = 0, solids = 0, write = 0;
};

/// Everything that is known about an object in its foams.
struct Packing {
    Vec3d rotation_deg;  ///< as the design has them
    Vec3d offset_mm;
    Placement placement;
    DesignSpace space;
    std::optional<CaseSpace> fitted_case;  ///< where the design has a case: what `space` is of
    Available available;                   ///< blocks that exist in it
    BlockMap blocks;
    std::vector<Notch> notches;     ///< beside the object, where the design wants them and there is room
    long long rib_blocks = 0;       ///< cut because they stood too thin between cavities
    std::optional<FoamPair> foams;  ///< none where the object leaves the space (finding `outside`)
    FitReport fit;                  ///< of `foams`
    std::vector<Finding> findings;  ///< dangers first
    Timing timing;
};

/// Whether an object of this size (in the file's unit) is one that no one packs in such blocks: smaller than
/// a block on every axis, or longer than 5 m. The sentence says what each unit would make of it. None where
/// the unit was chosen.
[[nodiscard]] std::optional<Error> implausible_size(Vec3d size, const Design& design);

/// Scales the mesh or cloud to millimetres, refuses an implausible size unless the unit was chosen, measures
/// it and looks for holes. Fails with kind `input`.
[[nodiscard]] Result<Object> prepare(Mesh mesh, const Design& design);

/// Makes packings and climbs many times faster, with the same results. Takes about as long as reading the
/// file, so it does not pay for one packing.
void prepare_for_many(Object& object);

/// The method, for a mesh or a cloud. `design` must be checked() already. Fails with kind `usage` where a
/// fitted space would need too many blocks, or where the parting level lies outside it, and with kind
/// `does_not_fit` where not one block goes into the case.
[[nodiscard]] Result<Packing> pack(const Object& object, const Design& design);

/// The gap report of a packing that has foams. Fails only when cancelled.
[[nodiscard]] Result<GapReport> gaps(const Object& object, const Packing& packing,
                                     const Progress& progress = {});

/// What the object lies on in either half of a packing that has foams. Fails only when cancelled.
[[nodiscard]] Result<BearingReport> bearing(const Object& object, const Packing& packing,
                                            const Progress& progress = {});

}  // namespace snug
