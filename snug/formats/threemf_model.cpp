#include "snug/formats/threemf_model.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "snug/base/text.h"
#include "snug/formats/text_scan.h"
#include "snug/formats/threemf_extensions.h"
#include "snug/formats/threemf_mesh.h"
#include "snug/formats/threemf_package.h"
#include "snug/formats/xml_read.h"
#include "snug/formats/xml_text.h"

namespace snug {
namespace {

tl::unexpected<Error> wrong(const XmlReader& xml, Message what) {
    return fail(ErrorKind::input, say("at_place", {{"place", xml.place()}, {"problem", std::move(what)}}));
}

Result<double> mm_per_unit(XmlReader& xml) {
    static constexpr std::pair<std::string_view, double> kUnits[] = {{"micron", 0.001},  {"millimeter", 1},
                                                                     {"centimeter", 10}, {"inch", 25.4},
                                                                     {"foot", 304.8},    {"meter", 1000}};
    const std::string_view unit = xml.attribute("unit").value_or("millimeter");
    for (const auto& [name, mm] : kUnits)
        if (same_word(unit, name)) return mm;
    return wrong(xml, say("threemf.unit", {{"unit", quoted(unit)}}));
}

/// Row by row, a matrix that rows of points are multiplied with; the last row is the shift.
std::optional<Affine> parse_transform(std::string_view text, double mm) {
    std::array<double, 12> values{};
    for (double& value : values) {
        text = without_xml_spaces(text);
        const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
        if (!to_number(text.substr(0, end), value)) return {};
        text.remove_prefix(end);
    }
    if (!without_xml_spaces(text).empty()) return {};
    const auto& m = values;
    return Affine{{Vec3d{m[0], m[3], m[6]}, Vec3d{m[1], m[4], m[7]}, Vec3d{m[2], m[5], m[8]}},
                  Vec3d{m[9], m[10], m[11]} * mm};
}

/// Reads the elements of one model.
class ModelReader {
  public:
    ModelReader(Bytes document, ThreeMfTotals& totals) : xml_(document), totals_(totals) {}

    Result<ThreeMfModel> read() && {
        auto event = xml_.next();
        if (!event) return tl::unexpected(event.error());
        if (*event != XmlEvent::start || xml_.name() != "model" || !is_3mf_core(xml_.space()))
            return wrong(xml_, say("threemf.no_model", {{"name", quoted(xml_.name())}}));
        if (auto good = check_required_extensions(xml_); !good) return tl::unexpected(good.error());
        const auto mm = mm_per_unit(xml_);
        if (!mm) return tl::unexpected(mm.error());
        mm_ = *mm;
        auto done = children([this](std::string_view name) -> Result<bool> {
            if (name == "resources")
                return taken(children([this](std::string_view inner) -> Result<bool> {
                    return inner == "object" ? taken(object()) : false;
                }));
            if (name != "build") return false;
            return taken(children([this](std::string_view inner) -> Result<bool> {
                return inner == "item" ? taken(use(model_.build)) : false;
            }));
        });
        if (!done) return tl::unexpected(done.error());
        return std::move(model_);
    }

  private:
    static Result<bool> taken(Result<void> done) {
        if (!done) return tl::unexpected(done.error());
        return true;
    }

    /// After a start: asks `take` with each child's name, empty for one of an extension; what it does not
    /// take is passed over. Stops behind the element's end.
    template <class Take>
    Result<void> children(Take take) {
        for (;;) {
            const auto event = xml_.next();
            if (!event) return tl::unexpected(event.error());
            if (*event != XmlEvent::start) return {};
            const auto took = take(is_3mf_core(xml_.space()) ? xml_.name() : std::string_view());
            if (!took) return tl::unexpected(took.error());
            if (*took) continue;
            if (auto done = xml_.skip(); !done) return done;
        }
    }

    Result<std::int64_t> id(std::string_view attribute) {
        std::int64_t value = 0;
        const auto text = xml_.attribute(attribute);
        if (!text || !to_number(*text, value) || value < 0)
            return wrong(xml_, say("threemf.no_whole_number",
                                   {{"attribute", attribute}, {"name", quoted(xml_.name())}}));
        return value;
    }

    Result<void> object() {
        const auto number = id("id");
        if (!number) return tl::unexpected(number.error());
        if (++totals_.objects > ThreeMfTotals::kMostObjects)
            return wrong(xml_, too_many_in_3mf("threemf.too_many_objects", ThreeMfTotals::kMostObjects));
        const auto [place, is_new] = model_.objects.try_emplace(*number);
        if (!is_new) return wrong(xml_, say("threemf.same_id", {{"id", std::to_string(*number)}}));
        ThreeMfObject& object = place->second;
        const std::string_view type = xml_.attribute("type").value_or("model");
        if (type == "support" || type == "solidsupport") object.role = ThreeMfRole::support;
        if (type == "other") object.role = ThreeMfRole::other;
        return children([&](std::string_view name) -> Result<bool> {
            if (name == "mesh") return taken(read_3mf_mesh(xml_, mm_, object));
            if (name == "components")
                return taken(children([&](std::string_view inner) -> Result<bool> {
                    return inner == "component" ? taken(use(object.components)) : false;
                }));
            note_unread(object);
            return false;
        });
    }

    /// Shapes of extensions, in place of a mesh.
    void note_unread(ThreeMfObject& object) const {
        if (xml_.name() == "booleanshape") object.unread = "threemf.boolean";
        if (xml_.name() == "levelset") object.unread = "threemf.level_set";
        if (xml_.name() == "displacementmesh") object.unread = "threemf.displaced";
    }

    /// An item or a component.
    Result<void> use(std::vector<ThreeMfUse>& uses) {
        const auto number = id("objectid");
        if (!number) return tl::unexpected(number.error());
        if (++totals_.uses > ThreeMfTotals::kMostUses)
            return wrong(xml_, too_many_in_3mf("threemf.too_many_uses", ThreeMfTotals::kMostUses));
        ThreeMfUse found;
        found.object = *number;
        if (const auto path = xml_.attribute(kThreeMfProduction, "path"))
            found.part = ThreeMfPackage::part_name(*path);
        if (const auto text = xml_.attribute("transform"); text && !text->empty()) {
            const auto place = parse_transform(*text, mm_);
            if (!place) return wrong(xml_, say("threemf.transform", {{"object", std::to_string(*number)}}));
            found.place = *place;
        }
        uses.push_back(std::move(found));
        return xml_.skip();
    }

    XmlReader xml_;
    ThreeMfTotals& totals_;
    double mm_ = 1;
    ThreeMfModel model_;
};

}  // namespace

Result<ThreeMfModel> read_3mf_model(Bytes xml, ThreeMfTotals& totals) {
    return ModelReader(xml, totals).read();
}

Message too_many_in_3mf(const char* code, std::uint64_t most) {
    return say(code, {{"most", most}});
}

}  // namespace snug
