// SPDX-License-Identifier: Apache-2.0
#include "json_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

using nlohmann::json;

constexpr int kDeepestNesting = 64;

/// A key as it stands in a JSON pointer (RFC 6901).
std::string pointer_token(const std::string& key) {
    std::string token;
    for (const char c : key) {
        if (c == '~') {
            token += "~0";
        } else if (c == '/') {
            token += "~1";
        } else {
            token += c;
        }
    }
    return token;
}

std::string kind_of(const json& value) {
    switch (value.type()) {
        case json::value_t::null:
            return "null";
        case json::value_t::object:
            return "an object";
        case json::value_t::array:
            return "an array";
        case json::value_t::string:
            return "a text";
        case json::value_t::boolean:
            return value.get<bool>() ? "true" : "false";
        default:
            return fmt::format("{}", value.dump());
    }
}

float linear_from_srgb(int byte) {
    const double s = byte / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

/// Line of a byte offset, counted from 1.
std::ptrdiff_t line_at(const std::string& text, std::size_t offset) {
    const std::size_t end = std::min(offset, text.size());
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
}

/// What nlohmann's message says, without its own prefix "[json.exception...] parse error at line ...: ".
std::string reason_in(const std::string& what) {
    const auto bracket = what.find("] ");
    std::string reason = bracket == std::string::npos ? what : what.substr(bracket + 2);
    if (reason.starts_with("parse error at")) {
        if (const auto colon = reason.find(": "); colon != std::string::npos)
            reason = reason.substr(colon + 2);
    }
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    return reason;
}

/// Refuses what the parser itself lets pass: a key that comes twice in one object, and bottomless nesting.
class StrictParse {
  public:
    explicit StrictParse(const std::string& file) : file_(file) {}
    bool operator()(int depth, json::parse_event_t event, json& parsed) {
        if (depth > kDeepestNesting) {
            throw InputError(file_, "", fmt::format("is nested deeper than {} levels", kDeepestNesting));
        }
        if (event == json::parse_event_t::object_start) {
            keys_.emplace_back();
        } else if (event == json::parse_event_t::object_end) {
            keys_.pop_back();
        } else if (event == json::parse_event_t::key &&
                   !keys_.back().insert(parsed.get<std::string>()).second) {
            throw InputError(file_, "",
                             fmt::format("key \"{}\" comes twice in one object", parsed.get<std::string>()));
        }
        return true;
    }

  private:
    const std::string& file_;
    std::vector<std::set<std::string>> keys_;
};

}  // namespace

bool NumberRange::accepts(double value) const {
    return std::isfinite(value) && (above_low ? value > low : value >= low) &&
           (below_high ? value < high : value <= high);
}

std::string NumberRange::words() const {
    const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
    const std::string lower = fmt::format("{} {}", above_low ? "greater than" : "at least", low);
    const std::string upper = fmt::format("{} {}", below_high ? "less than" : "at most", high);
    if (has_low && has_high) return lower + " and " + upper;
    if (has_low) return lower;
    if (has_high) return upper;
    return "finite";
}

void JsonNode::fail(const std::string& reason) const {
    throw InputError(*file_, path_.empty() ? "/" : path_, reason);
}

double JsonNode::number(NumberRange range) const {
    if (!value_->is_number()) fail(fmt::format("must be a number, not {}", kind_of(*value_)));
    const auto value = value_->get<double>();
    if (!range.accepts(value)) fail(fmt::format("must be {}, not {}", range.words(), value));
    return value;
}

int JsonNode::integer(int low, int high) const {
    const bool whole = value_->is_number() && std::floor(value_->get<double>()) == value_->get<double>();
    if (!whole) fail(fmt::format("must be a whole number, not {}", kind_of(*value_)));
    const auto value = value_->get<double>();
    if (value < low || value > high) fail(fmt::format("must be from {} to {}, not {}", low, high, value));
    return static_cast<int>(value);
}

bool JsonNode::boolean() const {
    if (!value_->is_boolean()) fail(fmt::format("must be true or false, not {}", kind_of(*value_)));
    return value_->get<bool>();
}

std::string JsonNode::text() const {
    if (!value_->is_string()) fail(fmt::format("must be a text, not {}", kind_of(*value_)));
    auto text = value_->get<std::string>();
    if (text.empty()) fail("must not be empty");
    return text;
}

glm::dvec2 JsonNode::pair() const {
    array_size(2, 2);
    return {item(0).number(), item(1).number()};
}

glm::dvec3 JsonNode::triple() const {
    array_size(3, 3);
    return {item(0).number(), item(1).number(), item(2).number()};
}

Rgb JsonNode::colour() const {
    if (value_->is_string()) {
        const auto text = value_->get<std::string>();
        const bool hex = text.size() == 7 && text[0] == '#' &&
                         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
        if (!hex) fail("must be \"#rrggbb\" or three numbers in linear light");
        const auto byte = [&](std::size_t at) { return std::stoi(text.substr(at, 2), nullptr, 16); };
        return {linear_from_srgb(byte(1)), linear_from_srgb(byte(3)), linear_from_srgb(byte(5))};
    }
    if (!value_->is_array()) fail("must be \"#rrggbb\" or three numbers in linear light");
    array_size(3, 3);
    const auto channel = [&](std::size_t i) { return static_cast<float>(item(i).number(between(0, 1e6))); };
    return {channel(0), channel(1), channel(2)};
}

std::size_t JsonNode::array_size(std::size_t least, std::size_t most) const {
    if (!value_->is_array()) fail(fmt::format("must be an array, not {}", kind_of(*value_)));
    const std::size_t size = value_->size();
    if (least == most && size != least) fail(fmt::format("must have {} items, not {}", least, size));
    if (size < least) fail(fmt::format("must have at least {} items, not {}", least, size));
    if (size > most) fail(fmt::format("must have at most {} items, not {}", most, size));
    return size;
}

JsonNode JsonNode::item(std::size_t i) const {
    return {(*value_)[i], *file_, fmt::format("{}/{}", path_, i)};
}

JsonObject::JsonObject(const JsonNode& node) : node_(node) {
    if (!node.value().is_object()) node.fail(fmt::format("must be an object, not {}", kind_of(node.value())));
}

JsonNode JsonObject::required(const std::string& key) {
    auto found = optional(key);
    if (!found) node_.fail(fmt::format("lacks the key \"{}\"", key));
    return *found;
}

std::optional<JsonNode> JsonObject::optional(const std::string& key) {
    known_.insert(key);
    const auto found = node_.value().find(key);
    if (found == node_.value().end()) return std::nullopt;
    return JsonNode(*found, node_.file(), node_.path() + "/" + pointer_token(key));
}

double JsonObject::number_or(const std::string& key, double otherwise, NumberRange range) {
    const auto found = optional(key);
    return found ? found->number(range) : otherwise;
}

int JsonObject::integer_or(const std::string& key, int otherwise, int low, int high) {
    const auto found = optional(key);
    return found ? found->integer(low, high) : otherwise;
}

bool JsonObject::boolean_or(const std::string& key, bool otherwise) {
    const auto found = optional(key);
    return found ? found->boolean() : otherwise;
}

std::string JsonObject::text_or(const std::string& key, const std::string& otherwise) {
    const auto found = optional(key);
    return found ? found->text() : otherwise;
}

Rgb JsonObject::colour_or(const std::string& key, Rgb otherwise) {
    const auto found = optional(key);
    return found ? found->colour() : otherwise;
}

std::string JsonObject::exactly_one_of(std::initializer_list<const char*> keys) {
    std::string present, names;
    for (const char* key : keys) {
        known_.insert(key);
        names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", key);
        if (!node_.value().contains(key)) continue;
        if (!present.empty())
            node_.fail(fmt::format("has both \"{}\" and \"{}\"; one is enough", present, key));
        present = key;
    }
    if (present.empty()) node_.fail("lacks one of the keys " + names);
    return present;
}

void JsonObject::no_other_keys() const {
    for (const auto& entry : node_.value().items()) {
        if (known_.contains(entry.key())) continue;
        std::string names;
        for (const std::string& key : known_) names += (names.empty() ? "" : ", ") + key;
        JsonNode(entry.value(), node_.file(), node_.path() + "/" + pointer_token(entry.key()))
            .fail("unknown key; known here: " + names);
    }
}

json parse_json(const std::string& text, const std::string& file) {
    StrictParse strict(file);
    try {
        return json::parse(text, std::ref(strict));
    } catch (const json::parse_error& error) {
        throw InputError(file, fmt::format("{}", line_at(text, error.byte)), reason_in(error.what()));
    } catch (const json::exception& error) {
        throw InputError(file, "", reason_in(error.what()));
    }
}

json parse_json_file(const std::string& file) {
    return parse_json(file_bytes(file), file);
}

std::string file_bytes(const std::string& file) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) throw InputError(file, "", "is a folder, not a file");
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file, "", "cannot be opened");
    std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (in.bad()) throw InputError(file, "", "cannot be read");
    return bytes;
}

}  // namespace keikan
