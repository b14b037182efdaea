// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "keikan/image/image.hpp"

namespace keikan {

/// The numbers that a key accepts, with the words that say so.
struct NumberRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool above_low = false;   ///< low itself is not accepted
    bool below_high = false;  ///< high itself is not accepted

    bool accepts(double value) const;
    std::string words() const;
};

inline NumberRange any_number() {
    return {};
}
inline NumberRange positive() {
    return {.low = 0, .above_low = true};
}
inline NumberRange at_least(double low) {
    return {.low = low};
}
inline NumberRange between(double low, double high) {
    return {.low = low, .high = high};
}
inline NumberRange positive_up_to(double high) {
    return {.low = 0, .high = high, .above_low = true};
}

/// A value of a JSON document that knows its file and place, so that every complaint about it names both.
/// Every accessor that cannot give what its name says throws an InputError.
class JsonNode {
  public:
    JsonNode(const nlohmann::json& value, const std::string& file, std::string path)
        : value_(&value), file_(&file), path_(std::move(path)) {}

    const nlohmann::json& value() const { return *value_; }
    const std::string& file() const { return *file_; }
    const std::string& path() const { return path_; }
    [[noreturn]] void fail(const std::string& reason) const;

    double number(NumberRange range = {}) const;
    int integer(int low, int high) const;
    bool boolean() const;
    std::string text() const;
    glm::dvec2 pair() const;
    glm::dvec3 triple() const;
    /// Three numbers of at least 0 in linear light, or "#rrggbb" in sRGB.
    Rgb colour() const;
    std::size_t array_size(std::size_t least = 0,
                           std::size_t most = std::numeric_limits<std::size_t>::max()) const;
    JsonNode item(std::size_t i) const;

  private:
    const nlohmann::json* value_;
    const std::string* file_;
    std::string path_;
};

/// An object of a JSON document whose keys are all accounted for: what was not asked for is an error.
///
///     JsonObject object(node);
///     design.sag_m = object.required("sag_m").number(positive());
///     if (auto it = object.optional("name")) design.name = it->text();
///     object.no_other_keys();
class JsonObject {
  public:
    explicit JsonObject(const JsonNode& node);

    JsonNode required(const std::string& key);
    std::optional<JsonNode> optional(const std::string& key);
    double number_or(const std::string& key, double otherwise, NumberRange range = {});
    int integer_or(const std::string& key, int otherwise, int low, int high);
    bool boolean_or(const std::string& key, bool otherwise);
    std::string text_or(const std::string& key, const std::string& otherwise);
    Rgb colour_or(const std::string& key, Rgb otherwise);
    /// Which one of `keys` is there. Errors: none of them, or more than one.
    std::string exactly_one_of(std::initializer_list<const char*> keys);
    void no_other_keys() const;

    const JsonNode& node() const { return node_; }
    [[noreturn]] void fail(const std::string& reason) const { node_.fail(reason); }

  private:
    JsonNode node_;
    std::set<std::string> known_;
};

/// Parses a JSON file strictly: no duplicate keys, no values after the end, no numbers beyond double, no
/// nesting deeper than 64. Errors: InputError with file, line and reason.
nlohmann::json parse_json_file(const std::string& file);
/// The same for a text that is said to come from `file`.
nlohmann::json parse_json(const std::string& text, const std::string& file);
/// The bytes of a file. Errors: InputError where it cannot be read.
std::string file_bytes(const std::string& file);

}  // namespace keikan
