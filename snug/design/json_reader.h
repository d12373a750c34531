#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "snug/base/result.h"
#include "snug/base/vec.h"

namespace snug {

/// What is wrong with the field of this path; an empty path is the whole file.
[[nodiscard]] Message must_be(std::string_view path, Message expected);
[[nodiscard]] Message not_an_object(std::string_view path);
[[nodiscard]] Message unknown_field(std::string_view path);

/// Reads the fields of one JSON object, strictly: the first wrong or unknown field is kept as the problem,
/// with its path, and everything after it is left alone.
class JsonReader {
  public:
    JsonReader(const nlohmann::json& value, std::string path);

    /// The object inside a field; an empty one where the field is missing.
    [[nodiscard]] JsonReader object(const char* name);
    /// The objects of a list, at least one and at most `most` of them.
    [[nodiscard]] std::vector<JsonReader> objects(const char* name, std::size_t most);

    JsonReader& read(const char* name, bool& target);
    JsonReader& read(const char* name, int& target);
    JsonReader& read(const char* name, unsigned long long& target);
    JsonReader& read(const char* name, double& target);
    JsonReader& read(const char* name, std::string& target);
    JsonReader& read(const char* name, Vec3d& target);

    /// null or a value.
    template <class T>
    JsonReader& read(const char* name, std::optional<T>& target) {
        if (const nlohmann::json* field = find(name); field && field->is_null()) {
            target.reset();
            return *this;
        }
        if (!has(name)) return *this;
        T value{};
        read(name, value);
        if (!problem_) target = value;
        return *this;
    }

    /// Says that `name` must be what `expected` names ("a number").
    void refuse(const char* name, Message expected);
    void require(const char* name);
    [[nodiscard]] bool has(const char* name) const { return value_.is_object() && value_.contains(name); }

    /// The first problem, or that of a field that was never asked for.
    [[nodiscard]] std::optional<Message> problem() const;
    /// Takes over the problem of a nested reader.
    void adopt(const JsonReader& nested);

  private:
    const nlohmann::json* find(const char* name);
    [[nodiscard]] std::string path_of(std::string_view name) const;

    nlohmann::json value_;
    std::string path_;
    std::vector<std::string> known_;
    std::optional<Message> problem_;
};

/// The value of a JSON text, or what is wrong with it and at which byte. Nesting is limited.
[[nodiscard]] Result<nlohmann::json> parse_json(std::string_view text, ErrorKind kind);

}  // namespace snug
