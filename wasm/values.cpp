#include "wasm/values.h"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "snug/object/zone_surface.h"

#include "wasm/fit_values.h"

namespace snug::wasm {
namespace {

// More parts than anyone reads; a soup may have a million.
constexpr std::size_t kMostParts = 1000;

const char* kind_name(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::usage:
            return "usage";
        case ErrorKind::input:
            return "input";
        case ErrorKind::does_not_fit:
            return "does_not_fit";
        case ErrorKind::output:
            return "output";
        case ErrorKind::cancelled:
            return "cancelled";
    }
    return "input";
}

template <class T>
val or_null(const std::optional<T>& value) {
    return value ? val(*value) : val::null();
}

val triple(double x, double y, double z) {
    val array = val::array();
    array.set(0, x);
    array.set(1, y);
    array.set(2, z);
    return array;
}

/// `foams`: what the figures are of.
val fit_val(const FitReport& fit, const Foams& foams) {
    val walls = val::array(), pieces = val::array();
    for (const double wall : fit.wall_mm) walls.call<void>("push", wall);
    for (const Piece piece : foams.all()) {
        const PieceFigures& figures = fit.pieces[static_cast<std::size_t>(piece.index)];
        val own = val::object();
        own.set("blocks", static_cast<double>(figures.blocks));
        own.set("parts", figures.parts);
        pieces.call<void>("push", own);
    }
    val result = val::object();
    result.set("pieces", pieces);
    result.set("cut_blocks", static_cast<double>(fit.cut_blocks));
    result.set("volume_mm3", fit.foam_mm3);
    result.set("fill_ratio", fit.fill_ratio);
    result.set("wall_mm", walls);
    return result;
}

/// Column-major 4 x 4.
val matrix(const Placement& placement) {
    val array = val::array();
    for (int column = 0; column < 3; ++column) {
        for (const Vec3d& row : placement.rotation.row) array.call<void>("push", row[column]);
        array.call<void>("push", 0);
    }
    for (int axis = 0; axis < 3; ++axis) array.call<void>("push", placement.shift[axis]);
    array.call<void>("push", 1);
    return array;
}

template <class T>
void fill_from(const val& array, T* data, std::size_t size) {
    const val view{emscripten::typed_memory_view(size, data)};
    view.call<void>("set", array);
}

/// {first, end}: of each column, from -x.
val runs_val(const Grid<Run>& runs) {
    std::vector<std::int16_t> first, end;
    first.reserve(runs.size());
    end.reserve(runs.size());
    for (const Run run : runs) {
        first.push_back(run.first);
        end.push_back(run.end);
    }
    val result = val::object();
    result.set("first", typed_array(first.data(), first.size()));
    result.set("end", typed_array(end.data(), end.size()));
    return result;
}

void set_foams(val& result, const Foams& foams) {
    val pieces = val::array(), levels = val::array();
    for (const Grid<Run>& kept : foams.pieces) pieces.call<void>("push", runs_val(kept));
    for (const int level : foams.parting) levels.call<void>("push", level);
    result.set("pieces", pieces);
    result.set("open", foams.open());
    result.set("partingLevels", levels);
}

}  // namespace

std::vector<std::byte> bytes_from(const val& uint8_array) {
    std::vector<std::byte> bytes(uint8_array["length"].as<std::size_t>());
    fill_from(uint8_array, reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size());
    return bytes;
}

std::vector<float> floats_from(const val& float32_array) {
    std::vector<float> floats(float32_array["length"].as<std::size_t>());
    fill_from(float32_array, floats.data(), floats.size());
    return floats;
}

val to_uint8_array(const std::vector<std::byte>& bytes) {
    return typed_array(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

Progress progress_from(const val& function) {
    if (function.isNull() || function.isUndefined()) return {};
    return [function](double fraction) { return function(fraction).as<bool>(); };
}

Language language_of(std::string_view name) {
    return language_from_name(name).value_or(Language::english);
}

val to_val(const Message& message) {
    val both = val::array();
    for (const Language language : {Language::english, Language::japanese})
        both.call<void>("push", text(message, language));
    return both;
}

val to_val(Vec3d v) {
    return triple(v.x, v.y, v.z);
}

val to_val(Vec3i v) {
    return triple(v.x, v.y, v.z);
}

val to_val(const Error& error) {
    val result = val::object();
    result.set("error", to_val(error.message));
    result.set("kind", std::string(kind_name(error.kind)));
    return result;
}

val to_val(const Preset& preset) {
    val result = val::object();
    result.set("name", preset.name);
    result.set("title", preset.title);
    result.set("block_mm", to_val(preset.block_mm));
    result.set("clearance_mm", preset.clearance_mm);
    result.set("least_clearance_mm", least_clearance_mm(preset.block_mm));
    result.set("density_kg_m3", or_null(preset.density_kg_m3));
    result.set("creep_kpa", or_null(preset.creep_kpa));
    result.set("rigid", preset.rigid);
    result.set("worked", preset.worked);
    result.set("division", std::string(name_of(preset.division)));
    result.set("wall_mm", or_null(preset.wall_mm));
    val usual_for = val::array();
    for (const std::string_view work : names_of<Workshop>())
        if (!work.empty() && usual_preset(*value_named<Workshop>(work)) == preset.name)
            usual_for.call<void>("push", std::string(work));
    result.set("usual_for", usual_for);
    return result;
}

val to_val(const ObjectFile& file) {
    val result = val::object();
    result.set("name", file.name);
    result.set("bytes", static_cast<double>(file.bytes));
    result.set("sha256", file.sha256);
    if (!file.shape.empty()) result.set("shape", file.shape);
    return result;
}

val to_val(const Object& object, Vec3d file_size, const std::optional<Error>& refused) {
    const MeshMeasure& measure = object.measure;
    val parts = val::array();
    for (std::size_t i = 0; !refused && i < std::min(object.clean.parts.size(), kMostParts); ++i) {
        const PartShare& own = object.clean.parts[i];
        const auto& dropped = object.clean.dropped;
        val part = val::object();
        part.set("number", own.number);
        part.set("triangles", own.triangles);
        part.set("size_mm", to_val(own.bounds.size()));
        part.set("share", own.share);
        part.set("dropped", std::any_of(dropped.begin(), dropped.end(),
                                        [&](const PartShare& each) { return each.number == own.number; }));
        parts.call<void>("push", part);
    }
    val result = val::object();
    result.set("vertices", object.read.vertices);
    result.set("triangles", object.read.triangles);
    result.set("fileSize", to_val(file_size));
    result.set("size_mm", refused ? val::null() : to_val(measure.bounds.size()));
    result.set("origin_mm", refused ? val::null() : to_val(origin_mm(object)));
    result.set("statesUnit", object.mesh.read.in_mm);
    result.set("sizeProblem", refused ? to_val(refused->message) : val::null());
    result.set("cloud", object.is_cloud());
    result.set("watertight", measure.watertight);
    result.set("volume_mm3", refused ? val::null() : or_null(measure.volume));
    result.set("holes", measure.holes.size());
    result.set("parts", parts);
    result.set("partCount", object.clean.parts.size());
    return result;
}

val to_val(const Mesh& mesh) {
    static_assert(sizeof(Vec3f) == 3 * sizeof(float) && sizeof(Triangle) == 3 * sizeof(std::uint32_t));
    val result = val::object();
    result.set("positions",
               typed_array(reinterpret_cast<const float*>(mesh.vertices.data()), mesh.vertices.size() * 3));
    result.set("indices", typed_array(reinterpret_cast<const std::uint32_t*>(mesh.triangles.data()),
                                      mesh.triangles.size() * 3));
    return result;
}

namespace {

/// The items that a finding is of, or that it names, by their places among all of them.
val items_named(const Finding& finding, const std::vector<Item>& items) {
    val numbers = val::array();
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string& name = items[i].name;
        const auto& values = finding.message.values;
        const bool named = std::any_of(values.begin(), values.end(), [&](const Value& value) {
            const auto* const text = std::get_if<std::string>(&value.content);
            return (value.name == "one" || value.name == "other") && text && *text == name;
        });
        if (!name.empty() && (finding.of == name || named)) numbers.call<void>("push", i);
    }
    return numbers;
}

val item_val(const Item& item) {
    val result = val::object();
    result.set("name", item.name);
    result.set("object", item.object);
    result.set("layer", item.layer);
    result.set("rotation_deg", to_val(item.rotation_deg));
    result.set("offset_mm", to_val(item.offset_mm));
    result.set("placement", matrix(item.placement));
    result.set("bounds", box_val(item.placement.bounds));
    result.set("settled_mm", item.settled_mm);
    return result;
}

}  // namespace

val to_val(const std::vector<Finding>& findings, const std::vector<Item>& items) {
    val list = val::array();
    for (const Finding& finding : findings) {
        val entry = val::object();
        entry.set("severity", std::string(severity_name(finding.severity)));
        entry.set("code", std::string(finding.code()));
        entry.set("message", to_val(said_of_item(finding)));
        entry.set("where", finding.where ? to_val(*finding.where) : val::null());
        entry.set("items", items_named(finding, items));
        list.call<void>("push", entry);
    }
    return list;
}

val to_val(const Packing& packing, double library_ms) {
    val items = val::array();
    for (const Item& item : packing.items) items.call<void>("push", item_val(item));
    const Foams none;
    val result = val::object();
    result.set("blocks", to_val(packing.space.blocks));
    result.set("block_mm", to_val(packing.space.block_mm));
    result.set("exists", runs_val(packing.available));
    set_foams(result, packing.foams ? *packing.foams : none);
    result.set("items", items);
    result.set("pads", pads_val(packing));
    result.set("fit", packing.foams ? fit_val(packing.fit, *packing.foams) : val::null());
    result.set("findings", to_val(packing.findings, packing.items));
    result.set("library_ms", library_ms);
    return result;
}

namespace {

/// Of all layers, of one or of a half.
template <class Part>
val gap_part(const Part& gap) {
    val result = val::object();
    result.set("widest_mm", gap.widest_mm);
    result.set("widest_error_mm", gap.widest_error_mm);
    result.set("widest_at", to_val(gap.widest_at));
    result.set("step_mm3", gap.step_mm3);
    result.set("undercut_mm3", or_null(gap.undercut_mm3));
    return result;
}

val layer_gap_val(const GapReport& gap) {
    val result = gap_part(gap);
    result.set("lower", gap_part(gap.lower));
    result.set("upper", gap_part(gap.upper));
    std::vector<float> columns;
    for (const ColumnGap& c : gap.columns)
        columns.insert(columns.end(), {c.lower_step, c.lower_undercut, c.upper_step, c.upper_undercut});
    result.set("columns", typed_array(columns.data(), columns.size()));
    return result;
}

}  // namespace

val to_val(const GapFigures& whole, const std::vector<GapReport>& layers) {
    val list = val::array();
    for (const GapReport& layer : layers) list.call<void>("push", layer_gap_val(layer));
    val result = gap_part(whole);
    result.set("layers", list);
    return result;
}

val to_val(const BearingReport& bearing, const Design& design) {
    const auto list = [](const auto& numbers) {
        val result = val::array();
        for (const double number : numbers) result.call<void>("push", number);
        return result;
    };
    val pressure = val::array();
    for (const double area : bearing.lower_mm2) {
        const auto mass = mass_kg(design);
        pressure.call<void>("push", mass ? or_null(static_pressure_kpa(*mass, area)) : val::null());
    }
    val result = val::object();
    result.set("sinking_mm", list(kSinking));
    result.set("lower_mm2", list(bearing.lower_mm2));
    result.set("upper_mm2", list(bearing.upper_mm2));
    result.set("static_kpa", pressure);
    result.set("creep_kpa", or_null(design.fit.creep_kpa));
    return result;
}

val to_val(const FoundPlacement& placement) {
    val result = val::object();
    result.set("rotation_deg", to_val(placement.rotation_deg));
    result.set("offset_mm", to_val(placement.offset_mm));
    result.set("cut_blocks", static_cast<double>(placement.cut_blocks));
    return result;
}

val to_val(const PlacementSearch& search, const DesignSpace& space) {
    val result = to_val(search.best());
    result.set("fill_ratio",
               1 - static_cast<double>(search.best().cut_blocks) / static_cast<double>(space.block_count()));
    result.set("fraction", std::min(1.0, static_cast<double>(search.evaluations()) /
                                             static_cast<double>(kSearchEvaluations)));
    result.set("ended", search.finished() || search.evaluations() >= kSearchEvaluations);
    return result;
}

val to_val(const DirectionMap& map) {
    std::vector<float> directions, cut_blocks;
    std::vector<double> rotations, offsets;  // what is taken must be what was looked at, to the last bit
    const auto add = [](auto& list, Vec3d v) {
        for (int axis = 0; axis < 3; ++axis)
            list.push_back(static_cast<typename std::decay_t<decltype(list)>::value_type>(v[axis]));
    };
    for (const DirectionCut& cut : map.cuts()) {
        if (cut.cut_blocks < 0) continue;
        add(directions, cut.direction);
        cut_blocks.push_back(static_cast<float>(cut.cut_blocks));
        add(rotations, cut.rotation_deg);
        add(offsets, cut.offset_mm);
    }
    val result = val::object();
    result.set("directions", typed_array(directions.data(), directions.size()));
    result.set("cut_blocks", typed_array(cut_blocks.data(), cut_blocks.size()));
    result.set("rotations_deg", typed_array(rotations.data(), rotations.size()));
    result.set("offsets_mm", typed_array(offsets.data(), offsets.size()));
    result.set("fraction", std::min(1.0, static_cast<double>(map.passes()) / kMapPasses));
    result.set("ended", map.passes() >= kMapPasses);
    return result;
}

val to_val(const PackFile& file) {
    val result = val::object();
    result.set("name", file.name);
    result.set("bytes", to_uint8_array(file.bytes));
    return result;
}

}  // namespace snug::wasm
