// SPDX-License-Identifier: Apache-2.0
//
// What the formats of pixel cases have in common: the JSON of everything but the polygons.
#pragma once
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "keikan/model/pixel_case.hpp"

namespace keikan::cases {

using Json = nlohmann::json;

/// What is wrong with a case, and where in it. Whoever knows the file and the line adds them.
class BadCase : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
    BadCase(const std::string& where, const std::string& reason) : BadCase(where + " " + reason) {}
};

/// The JSON that `text` is. Errors: BadCase with the column, counted through the whole text.
Json parsed(std::string_view text);

const Json& array_of(const Json& value, const std::string& where);
const Json& array_of(const Json& value, std::size_t length, const char* of, const std::string& where);

/// A JSON number, or a string with a C hexadecimal float, as the double that it names.
double number(const Json& value, const std::string& where);

/// `ring`, if it is convex by exact signs. Errors: BadCase.
Ring convex(Ring ring, const std::string& where);

/// Sets id, pixel, depth and answers of `result` from the keys of `object`; its polygons must be there
/// already. `default_id` where the object has none. Errors: BadCase.
void read_attributes(const Json& object, const std::string& default_id, PixelCase& result);

/// `"id": ..., "pixel": ...`, then `polygons` as it is, then the other keys that the case has.
std::string attributes_text(const PixelCase& pixel_case, const std::string& polygons = "");

/// A double as JSON, with 17 significant digits.
std::string number_text(double value);
std::string point_text(Point p);

/// Line ends in [begin, end) of `text`.
std::size_t lines_between(std::string_view text, std::size_t begin, std::size_t end);

/// "[" + the items, each as `text_of` writes it, separated by commas + "]".
template <typename Items, typename TextOf>
std::string array_text(const Items& items, TextOf text_of) {
    std::string text = "[";
    for (const auto& item : items) {
        if (text.size() > 1) text += ", ";
        text += text_of(item);
    }
    return text + "]";
}

}  // namespace keikan::cases
