#include "snug/formats/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "snug/base/text.h"

namespace snug::gltf {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 7> kTypes = {
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};

constexpr std::uint64_t kStepsPerReplaced = 16;  // they are sorted

std::uint64_t size_of(Component component) {
    switch (component) {
        case Component::int8:
        case Component::uint8:
            return 1;
        case Component::int16:
        case Component::uint16:
            return 2;
        case Component::uint32:
        case Component::float32:
            break;
    }
    return 4;
}

template <class T>
double value_at(const std::byte* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

int components_of(std::string_view type) {
    const auto known =
        std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& t) { return t.first == type; });
    return known == kTypes.end() ? 0 : known->second;
}

}  // namespace

double divisor(Component component) {
    switch (component) {
        case Component::int8:
            return 127;
        case Component::uint8:
            return 255;
        case Component::int16:
            return 32767;
        case Component::uint16:
            return 65535;
        case Component::uint32:
            return 4294967295.0;
        case Component::float32:
            break;
    }
    return 1;
}

Result<Component> component_of(const Json& accessor, const char* name) {
    const auto number = whole(accessor, name, 0);
    if (!number) return tl::unexpected(number.error());
    if ((*number >= 5120 && *number <= 5123) || *number == 5125 || *number == 5126)
        return static_cast<Component>(*number);
    return refuse(say("gltf.component_type", {{"type", *number}}));
}

double Accessor::Elements::at(std::uint64_t i, int c) const {
    const std::byte* from = bytes.data() + i * stride + static_cast<std::uint64_t>(c) * size_of(component);
    switch (component) {
        case Component::int8:
            return value_at<std::int8_t>(from);
        case Component::uint8:
            return value_at<std::uint8_t>(from);
        case Component::int16:
            return value_at<std::int16_t>(from);
        case Component::uint16:
            return value_at<std::uint16_t>(from);
        case Component::uint32:
            return value_at<std::uint32_t>(from);
        case Component::float32:
            break;
    }
    return value_at<float>(from);
}

Accessor::Accessor(std::span<const float> values, int components, double scale)
    : count_(values.size() / static_cast<std::size_t>(components)),
      components_(components),
      normalised_(scale != 1),
      scale_(scale),
      base_{std::as_bytes(values), static_cast<std::uint64_t>(components) * sizeof(float),
            Component::float32} {}

std::uint64_t Accessor::greatest() const {
    switch (base_.component) {
        case Component::uint8:
            return 0xFF;
        case Component::uint16:
            return 0xFFFF;
        default:
            return 0xFFFFFFFF;
    }
}

double Accessor::scaled(double value) const {
    return normalised_ ? std::max(value / scale_, -1.0) : value;
}

double Accessor::at(std::uint64_t i, int c) const {
    if (!replaced_.empty()) {
        const auto found =
            std::lower_bound(replaced_.begin(), replaced_.end(), i,
                             [](const Replaced& r, std::uint64_t index) { return r.index < index; });
        if (found != replaced_.end() && found->index == i) return scaled(replacements_.at(found->place, c));
    }
    return base_.bytes.empty() ? 0 : scaled(base_.at(i, c));
}

Result<Accessor::Elements> Accessor::elements(Buffers& buffers, const Json& of, Component component,
                                              std::uint64_t components, std::uint64_t count) {
    const auto index = whole(of, "bufferView", 0), offset = whole(of, "byteOffset", 0);
    if (!index) return tl::unexpected(index.error());
    if (!offset) return tl::unexpected(offset.error());
    const auto view = buffers.view(*index);
    if (!view) return tl::unexpected(view.error());
    const std::uint64_t size = components * size_of(component),
                        stride = view->stride == 0 ? size : view->stride;
    const std::uint64_t there = view->bytes.size();
    if (count > 0 &&
        (*offset > there || size > there - *offset || count - 1 > (there - *offset - size) / stride))
        return refuse(
            say("gltf.accessor_too_long", {{"elements", count}, {"view", *index}, {"bytes", there}}));
    const Bytes bytes = count > 0 ? view->bytes.subspan(static_cast<std::size_t>(*offset)) : Bytes{};
    return Elements{bytes, stride, component};
}

Result<Accessor> Accessor::open(const Json& scene, Buffers& buffers, std::uint64_t index,
                                std::string_view type) {
    const Json& json = item(field(scene, "accessors"), index);
    if (!json.is_object()) return refuse(say("gltf.no_accessor", {{"index", index}}));
    const auto component = component_of(json);
    const auto count = whole(json, "count", 0);
    if (!component) return tl::unexpected(component.error());
    if (!count) return tl::unexpected(count.error());
    if (const std::string has = text_of(json, "type"); has != type)
        return refuse(
            say("gltf.accessor_type", {{"index", index}, {"has", snug::quoted(has)}, {"wanted", type}}));
    Accessor accessor;
    accessor.count_ = *count;
    accessor.components_ = components_of(type);
    accessor.base_.component = *component;
    const Json& normalised = field(json, "normalized");
    accessor.normalised_ =
        normalised.is_boolean() && normalised.get<bool>() && *component != Component::float32;
    accessor.scale_ = divisor(*component);
    if (!field(json, "bufferView").is_null()) {
        auto base =
            elements(buffers, json, *component, static_cast<std::uint64_t>(accessor.components_), *count);
        if (!base) return tl::unexpected(base.error());
        accessor.base_ = *base;
    }
    if (const Json& sparse = field(json, "sparse"); sparse.is_object())
        if (const auto done = accessor.replace(buffers, sparse); !done) return tl::unexpected(done.error());
    return accessor;
}

Result<void> Accessor::replace(Buffers& buffers, const Json& sparse) {
    const auto count = whole(sparse, "count", 0);
    if (!count) return tl::unexpected(count.error());
    const auto component = component_of(field(sparse, "indices"));
    if (!component) return tl::unexpected(component.error());
    const auto indices = elements(buffers, field(sparse, "indices"), *component, 1, *count);
    if (!indices) return tl::unexpected(indices.error());
    auto values = elements(buffers, field(sparse, "values"), base_.component,
                           static_cast<std::uint64_t>(components_), *count);
    if (!values) return tl::unexpected(values.error());
    if (const auto fair = buffers.spend(kStepsPerReplaced * *count); !fair) return fair;
    replacements_ = *values;
    replaced_.reserve(static_cast<std::size_t>(*count));
    for (std::uint64_t i = 0; i < *count; ++i) {
        const double at = indices->at(i, 0);
        if (!(at >= 0 && at < static_cast<double>(count_)))
            return refuse(say("gltf.sparse", {{"at", number(at, 0)}, {"count", count_}}));
        replaced_.push_back({static_cast<std::uint64_t>(at), i});
    }
    // In the order of their indices, as the specification has them; of equals the last stands.
    std::stable_sort(replaced_.begin(), replaced_.end(),
                     [](const Replaced& a, const Replaced& b) { return a.index < b.index; });
    const auto last = std::unique(replaced_.rbegin(), replaced_.rend(),
                                  [](const Replaced& a, const Replaced& b) { return a.index == b.index; });
    replaced_.erase(replaced_.begin(), last.base());
    return {};
}

}  // namespace snug::gltf
