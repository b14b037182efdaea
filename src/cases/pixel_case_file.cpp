// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/pixel_case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "keikan/cases/convex_ring.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

using Json = nlohmann::json;

/// Columns and rows beyond this could not be taken off a coordinate without care for overflow.
constexpr double kLargestPixel = 1 << 30;

/// What is wrong with a line, and where in it. PixelCaseReader::next adds the file and the line.
class BadCase : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
    BadCase(const std::string& where, const std::string& reason) : BadCase(where + " " + reason) {}
};

/// The double that a C hexadecimal float such as "-0x1.8p-3" names.
double hexadecimal_float(const std::string& text, const std::string& where) {
    const std::size_t digits = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    const bool prefixed = text.size() > digits + 2 && text[digits] == '0' &&
                          (text[digits + 1] == 'x' || text[digits + 1] == 'X');
    char* end = nullptr;
    const double value = prefixed ? std::strtod(text.c_str(), &end) : 0;
    if (!prefixed || end != text.c_str() + text.size())
        throw BadCase(where, "is a string, but not a hexadecimal float such as \"0x1.8p-3\"");
    return value;
}

double number(const Json& value, const std::string& where) {
    double result = 0;
    if (value.is_number())
        result = value.get<double>();
    else if (value.is_string())
        result = hexadecimal_float(value.get_ref<const std::string&>(), where);
    else
        throw BadCase(where, "is not a number");
    if (!std::isfinite(result)) throw BadCase(where, "is not finite");
    return result;
}

const Json& array_of(const Json& value, const std::string& where) {
    if (!value.is_array()) throw BadCase(where, "is not an array");
    return value;
}

const Json& array_of(const Json& value, std::size_t length, const char* of, const std::string& where) {
    if (!value.is_array() || value.size() != length)
        throw BadCase(where, fmt::format("is not an array of {} {}", length, of));
    return value;
}

int pixel_coordinate(const Json& value, const std::string& where) {
    const double coordinate = value.is_number() ? value.get<double>() : std::nan("");
    if (coordinate != std::floor(coordinate)) throw BadCase(where, "is not a whole number");
    if (std::abs(coordinate) > kLargestPixel) throw BadCase(where, "is beyond 2^30");
    return static_cast<int>(coordinate);
}

PixelIndex pixel_of(const Json& value) {
    array_of(value, 2, "whole numbers", "pixel");
    return {pixel_coordinate(value[0], "pixel[0]"), pixel_coordinate(value[1], "pixel[1]")};
}

Ring ring_of(const Json& value, const std::string& where) {
    Ring ring;
    for (const Json& point : array_of(value, where)) {
        const std::string at = fmt::format("{}[{}]", where, ring.size());
        array_of(point, 2, "coordinates", at);
        ring.push_back({number(point[0], at + "[0]"), number(point[1], at + "[1]")});
    }
    if (!is_convex_ring(ring)) throw BadCase(where, "is not convex");
    return ring;
}

DepthPlane plane_of(const Json& value, const std::string& where) {
    array_of(value, 3, "numbers", where);
    return {number(value[0], where + "[0]"), number(value[1], where + "[1]"),
            number(value[2], where + "[2]")};
}

/// An exact answer "p/q" or "p", kept as text: only the oracle calculates with it.
std::string fraction_of(const Json& value, const std::string& where) {
    if (!value.is_string()) throw BadCase(where, "is not a string \"p/q\"");
    const std::string& text = value.get_ref<const std::string&>();
    const auto all_digits = [](std::string_view digits) {
        return !digits.empty() && digits.find_first_not_of("0123456789") == digits.npos;
    };
    const std::string_view unsigned_text = std::string_view(text).substr(text.starts_with('-') ? 1 : 0);
    const std::size_t slash = unsigned_text.find('/');
    const bool whole = slash == unsigned_text.npos;
    const std::string_view denominator = whole ? "1" : unsigned_text.substr(slash + 1);
    if (!all_digits(unsigned_text.substr(0, slash)) || !all_digits(denominator))
        throw BadCase(where, "is not a fraction \"p/q\"");
    if (denominator.find_first_not_of('0') == denominator.npos) throw BadCase(where, "has the denominator 0");
    return text;
}

/// Every item of a list that runs beside `polygons`.
template <typename Item>
std::vector<Item> beside_polygons(const Json& value, std::size_t polygons, const std::string& name,
                                  Item (*item_of)(const Json&, const std::string&)) {
    if (array_of(value, name).size() != polygons)
        throw BadCase(name, fmt::format("has {} entries for {} polygons", value.size(), polygons));
    std::vector<Item> items;
    for (const Json& item : value) items.push_back(item_of(item, fmt::format("{}[{}]", name, items.size())));
    return items;
}

std::string id_of(const Json& value) {
    if (value.is_number_integer()) return value.dump();
    if (!value.is_string()) throw BadCase("id", "is not a string");
    return value.get<std::string>();
}

PixelCase case_of(const Json& line, long line_number) {
    if (!line.is_object()) throw BadCase("a pixel case is a JSON object");
    if (!line.contains("polygons")) throw BadCase("has no \"polygons\"");
    PixelCase result;
    result.id = line.contains("id") ? id_of(line["id"]) : std::to_string(line_number);
    if (line.contains("pixel")) result.pixel = pixel_of(line["pixel"]);
    for (const Json& polygon : array_of(line["polygons"], "polygons"))
        result.polygons.push_back(ring_of(polygon, fmt::format("polygons[{}]", result.polygons.size())));
    const std::size_t count = result.polygons.size();
    if (line.contains("depth")) result.depth = beside_polygons(line["depth"], count, "depth", plane_of);
    if (line.contains("areas")) result.areas = beside_polygons(line["areas"], count, "areas", fraction_of);
    if (line.contains("background")) result.background = fraction_of(line["background"], "background");
    return result;
}

Json parsed(const std::string& text) {
    try {
        return Json::parse(text);
    } catch (const Json::out_of_range&) {
        throw BadCase("a number is not finite: it lies beyond the range of a double");
    } catch (const Json::parse_error& error) {
        throw BadCase(fmt::format("broken JSON near column {}", error.byte));
    }
}

std::string number_text(double value) {
    if (value == 0) return std::signbit(value) ? "-0.0" : "0";
    return fmt::format("{:.17g}", value);
}

std::string json_text(const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

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

}  // namespace

PixelCaseReader::PixelCaseReader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

std::optional<PixelCase> PixelCaseReader::next() {
    std::string text;
    while (std::getline(in_, text)) {
        ++line_;
        if (text.find_first_not_of(" \t\r") == text.npos) continue;
        try {
            return case_of(parsed(text), line_);
        } catch (const BadCase& bad) {
            throw InputError(name_, std::to_string(line_), bad.what());
        }
    }
    if (in_.bad()) throw InputError(name_, std::to_string(line_ + 1), "cannot be read");
    return std::nullopt;
}

std::string pixel_case_line(const PixelCase& pixel_case) {
    const auto point_text = [](Point p) { return array_text(std::array{p.x, p.y}, number_text); };
    const auto ring_text = [&](const Ring& ring) { return array_text(ring, point_text); };
    const auto plane_text = [](const DepthPlane& plane) {
        return array_text(std::array{plane.a, plane.b, plane.c}, number_text);
    };
    const PixelIndex pixel = pixel_case.pixel;
    std::string line =
        fmt::format("{{\"id\": {}, \"pixel\": [{}, {}]", json_text(pixel_case.id), pixel.x, pixel.y);
    line += ", \"polygons\": " + array_text(pixel_case.polygons, ring_text);
    if (pixel_case.depth) line += ", \"depth\": " + array_text(*pixel_case.depth, plane_text);
    if (pixel_case.areas) line += ", \"areas\": " + array_text(*pixel_case.areas, json_text);
    if (pixel_case.background) line += ", \"background\": " + json_text(*pixel_case.background);
    return line + "}";
}

}  // namespace keikan
