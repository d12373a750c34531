#include "snug/design/json_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snug {
namespace {

using Json = nlohmann::json;

bool get(const Json& value, bool& target) {
    if (!value.is_boolean()) return false;
    target = value.get<bool>();
    return true;
}

bool get(const Json& value, double& target) {
    if (!value.is_number()) return false;
    target = value.get<double>();
    return std::isfinite(target);
}

bool get(const Json& value, int& target) {
    if (!value.is_number_integer()) return false;
    if (value.is_number_unsigned() && value.get<std::uint64_t>() > std::numeric_limits<int>::max())
        return false;
    const auto wide = value.get<std::int64_t>();
    if (wide < std::numeric_limits<int>::min() || wide > std::numeric_limits<int>::max()) return false;
    target = static_cast<int>(wide);
    return true;
}

bool get(const Json& value, unsigned long long& target) {
    if (!value.is_number_unsigned()) return false;
    target = value.get<std::uint64_t>();
    return true;
}

bool get(const Json& value, std::string& target) {
    if (!value.is_string()) return false;
    target = value.get<std::string>();
    return true;
}

template <class T>
bool get(const Json& value, Vec3<T>& target) {
    return value.is_array() && value.size() == 3 && get(value[0], target.x) && get(value[1], target.y) &&
           get(value[2], target.z);
}

}  // namespace

Message must_be(std::string_view path, Message expected) {
    return say("json.must_be", {{"path", path}, {"expected", std::move(expected)}});
}

Message not_an_object(std::string_view path) {
    return say("json.not_an_object", {{"path", path.empty() ? say("json.the_file") : as_it_is(path)}});
}

Message unknown_field(std::string_view path) {
    return say("json.unknown", {{"path", path}});
}

JsonReader::JsonReader(const Json& value, std::string path) : value_(value), path_(std::move(path)) {
    if (!value_.is_object()) problem_ = not_an_object(path_);
}

JsonReader JsonReader::object(const char* name) {
    const Json* field = find(name);
    return {field ? *field : Json::object(), path_of(name)};
}

std::vector<JsonReader> JsonReader::objects(const char* name, std::size_t most) {
    const Json* field = find(name);
    if (!field) return {};
    if (!field->is_array() || field->empty() || field->size() > most) {
        refuse(name, say("json.items", {{"most", std::to_string(most)}}));
        return {};
    }
    std::vector<JsonReader> readers;
    for (std::size_t i = 0; i < field->size(); ++i)
        readers.emplace_back((*field)[i], path_of(name) + "." + std::to_string(i));
    return readers;
}

JsonReader& JsonReader::read(const char* name, bool& target) {
    if (const Json* field = find(name); field && !get(*field, target))
        refuse(name, say("json.true_or_false"));
    return *this;
}
JsonReader& JsonReader::read(const char* name, int& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, say("takes.whole"));
    return *this;
}
JsonReader& JsonReader::read(const char* name, unsigned long long& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, say("json.whole_from_0"));
    return *this;
}
JsonReader& JsonReader::read(const char* name, double& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, say("takes.number"));
    return *this;
}
JsonReader& JsonReader::read(const char* name, std::string& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, say("takes.text"));
    return *this;
}
JsonReader& JsonReader::read(const char* name, Vec3d& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, say("json.three"));
    return *this;
}

void JsonReader::refuse(const char* name, Message expected) {
    if (!problem_) problem_ = must_be(path_of(name), std::move(expected));
}

void JsonReader::require(const char* name) {
    if (!has(name) && !problem_) problem_ = say("json.missing", {{"path", path_of(name)}});
}

std::string JsonReader::path_of(std::string_view name) const {
    return (path_.empty() ? "" : path_ + ".") + std::string(name);
}

std::optional<Message> JsonReader::problem() const {
    if (problem_) return problem_;
    for (const auto& [name, value] : value_.items())
        if (std::find(known_.begin(), known_.end(), name) == known_.end())
            return unknown_field(path_of(name));
    return {};
}

void JsonReader::adopt(const JsonReader& nested) {
    if (!problem_) problem_ = nested.problem();
}

const Json* JsonReader::find(const char* name) {
    known_.emplace_back(name);
    return has(name) ? &value_[name] : nullptr;
}

Result<Json> parse_json(std::string_view text, ErrorKind kind) {
    Json value = Json::parse(text.begin(), text.end(), nullptr, false);
    if (value.is_discarded()) return fail(kind, say("json.invalid"));
    return value;
}

}  // namespace snug
