#include "wasm/object_store.h"

#include <algorithm>
#include <utility>

#include "snug/mesh/measure.h"
#include "snug/object/prepare.h"
#include "snug/words/words.h"

namespace snug::wasm {
namespace {

const Error kNoObject{ErrorKind::usage, say("session.no_object")};

}  // namespace

bool asks_for_unit(const ObjectStore::Entry& entry, const Design& design) {
    return !entry.read.read.in_mm && entry.box.longest_side() > 0 && !design.object.units &&
           !design.object.longest_mm;
}

Object unscaled(const Mesh& mesh) {
    Object object;
    object.mesh.read = mesh.read;
    if (mesh.is_cloud()) object.surface = PointBalls{};
    object.read = {mesh.vertices.size(), mesh.triangles.size()};
    object.measure = measure(mesh);
    return object;
}

std::optional<Error> ObjectStore::load(int number, Mesh read, const Design& design) {
    const Box3d box = bounds(read);
    Entry entry{number, std::move(read), box};
    auto object = snug::prepare(entry.read, design);
    if (!object && !asks_for_unit(entry, design)) return object.error();
    entry.prepared = object.has_value();
    const auto error = object ? std::optional<Error>() : object.error();
    Object made = object ? std::move(*object) : Object();
    made.options = design.object;
    made.edition = ++edition_;
    entries_.push_back(std::move(entry));
    objects_.push_back(std::move(made));
    return error;
}

void ObjectStore::keep(std::span<const int> numbers) {
    for (std::size_t place = entries_.size(); place-- > 0;) {
        if (std::find(numbers.begin(), numbers.end(), entries_[place].number) != numbers.end()) continue;
        entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(place));
        objects_.erase(objects_.begin() + static_cast<std::ptrdiff_t>(place));
        ++edition_;
    }
    laid_out_ = std::min(laid_out_, objects_.size());
}

std::optional<std::size_t> ObjectStore::place_of(int number) const {
    for (std::size_t place = 0; place < entries_.size(); ++place)
        if (entries_[place].number == number) return place;
    return {};
}

std::optional<Error> ObjectStore::prepare(int number, const Design& design) {
    const auto place = place_of(number);
    return place ? prepare_at(*place, design) : kNoObject;
}

std::optional<Error> ObjectStore::prepare_at(std::size_t place, const Design& design) {
    Entry& entry = entries_[place];
    if (entry.prepared && objects_[place].options == design.object)
        return objects_[place].mesh.read.in_mm ? std::nullopt : implausible_size(entry.box.size(), design);
    auto object = snug::prepare(entry.read, design);
    if (!object) return object.error();
    object->options = design.object;
    object->edition = ++edition_;
    objects_[place] = std::move(*object);
    entry.prepared = true;
    entry.surface.reset();
    return {};
}

std::optional<Error> ObjectStore::lay_out(std::span<const int> numbers, const Project& project) {
    if (numbers.size() != project.objects.size() || numbers.empty()) return kNoObject;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto place = place_of(numbers[i]);
        if (!place || *place < i) return kNoObject;
        if (*place == i) continue;
        std::swap(entries_[i], entries_[*place]);
        std::swap(objects_[i], objects_[*place]);
        ++edition_;
    }
    if (laid_out_ != numbers.size()) ++edition_;
    laid_out_ = numbers.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (const auto error = prepare_at(i, design_for(project, i))) {
            const std::string& name = project.objects[i].file.name;
            const bool names = numbers.size() > 1 && !name.empty();
            return names ? Error{error->kind, in_file(name, error->message)} : *error;
        }
        objects_[i].name = project.objects[i].file.name;
    }
    return {};
}

const ObjectStore::Entry* ObjectStore::find(int number) const {
    const auto place = place_of(number);
    return place ? &entries_[*place] : nullptr;
}

const Object& ObjectStore::object_of(const Entry& entry) const {
    return objects_[static_cast<std::size_t>(&entry - entries_.data())];
}

Result<const SurfaceDistance*> ObjectStore::surface_of(std::size_t object) {
    auto& surface = entries_[object].surface;
    if (!surface) {
        auto built = SurfaceDistance::build(objects_[object].mesh);
        if (!built) return tl::unexpected(built.error());
        surface.emplace(std::move(*built));
    }
    return &*surface;
}

}  // namespace snug::wasm
