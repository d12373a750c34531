#include "snug/design/json_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "snug/base/text.h"

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

template <class T>
bool get(const Json& value, std::vector<T>& target) {
    if (!value.is_array()) return false;
    target.assign(value.size(), {});
    for (std::size_t i = 0; i < value.size(); ++i)
        if (!get(value[i], target[i])) return false;
    return true;
}

}  // namespace

JsonReader::JsonReader(const Json& value, std::string path) : value_(value), path_(std::move(path)) {
    if (!value_.is_object())
        problem_ = (path_.empty() ? std::string("the file") : path_) + " must be a JSON object";
}

JsonReader JsonReader::object(const char* name) {
    const std::string path = path_.empty() ? name : path_ + "." + name;
    const Json* field = find(name);
    return {field ? *field : Json::object(), path};
}

JsonReader& JsonReader::read(const char* name, bool& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, "true or false");
    return *this;
}
JsonReader& JsonReader::read(const char* name, int& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, "a whole number");
    return *this;
}
JsonReader& JsonReader::read(const char* name, unsigned long long& target) {
    if (const Json* field = find(name); field && !get(*field, target))
        refuse(name, "a whole number of 0 or more");
    return *this;
}
JsonReader& JsonReader::read(const char* name, double& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, "a number");
    return *this;
}
JsonReader& JsonReader::read(const char* name, std::string& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, "a text");
    return *this;
}
JsonReader& JsonReader::read(const char* name, Vec3d& target) {
    if (const Json* field = find(name); field && !get(*field, target))
        refuse(name, "three numbers in brackets");
    return *this;
}
JsonReader& JsonReader::read(const char* name, Vec3i& target) {
    if (const Json* field = find(name); field && !get(*field, target))
        refuse(name, "three whole numbers in brackets");
    return *this;
}
JsonReader& JsonReader::read(const char* name, std::vector<std::string>& target) {
    if (const Json* field = find(name); field && !get(*field, target)) refuse(name, "a list of texts");
    return *this;
}

JsonReader& JsonReader::read(const char* name, std::vector<int>& target) {
    if (const Json* field = find(name); field && !get(*field, target))
        refuse(name, "a list of whole numbers");
    return *this;
}

JsonReader& JsonReader::read(const char* name, std::map<std::string, int>& target) {
    const Json* field = find(name);
    if (!field) return *this;
    target.clear();
    if (!field->is_object()) refuse(name, "names with a whole number each");
    if (field->is_object())
        for (const auto& [key, value] : field->items())
            if (!get(value, target[key])) refuse(name, "names with a whole number each");
    return *this;
}

JsonReader::Numbers JsonReader::read_numbers(const char* name, std::span<double> values, bool one_for_all) {
    const Json* field = find(name);
    if (!field) return Numbers::missing;
    if (field->is_null()) return Numbers::null;
    const bool list = field->is_array();
    if (list ? field->size() != values.size() : !one_for_all) return Numbers::wrong;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!get(list ? (*field)[i] : *field, values[i])) return Numbers::wrong;
    return Numbers::good;
}

bool JsonReader::is_null(const char* name) {
    const Json* field = find(name);
    return field && field->is_null();
}

void JsonReader::refuse(const char* name, std::string_view expected) {
    if (!problem_) problem_ = (path_.empty() ? "" : path_ + ".") + name + " must be " + std::string(expected);
}

void JsonReader::require(const char* name) {
    if (!has(name) && !problem_) problem_ = (path_.empty() ? "" : path_ + ".") + name + " is missing";
}

std::optional<std::string> JsonReader::problem() const {
    if (problem_) return problem_;
    for (const auto& [name, value] : value_.items())
        if (std::find(known_.begin(), known_.end(), name) == known_.end())
            return (path_.empty() ? "" : path_ + ".") + name +
                   " is not an option that this version of Snug knows";
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
    if (value.is_discarded()) return fail(kind, "this is not valid JSON (cut off, or edited by hand?)");
    return value;
}

}  // namespace snug
