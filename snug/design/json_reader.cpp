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
