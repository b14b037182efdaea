// SPDX-License-Identifier: Apache-2.0
#include "case_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "keikan/cases/convex_ring.hpp"

namespace keikan::cases {
namespace {

/// Columns and rows beyond this could not be taken off a coordinate without care for overflow.
constexpr double kLargestPixel = 1 << 30;

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

std::string json_text(const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json parsed(std::string_view text) {
    try {
        return Json::parse(text);
    } catch (const Json::out_of_range&) {
        throw BadCase("a number is not finite: it lies beyond the range of a double");
    } catch (const Json::parse_error& error) {
        throw BadCase(fmt::format("broken JSON near column {}", error.byte));
    }
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

Ring convex(Ring ring, const std::string& where) {
    if (!is_convex_ring(ring)) throw BadCase(where, "is not convex");
    return ring;
}

void read_attributes(const Json& object, const std::string& default_id, PixelCase& result) {
    const std::size_t count = result.polygons.size();
    result.id = object.contains("id") ? id_of(object["id"]) : default_id;
    if (object.contains("pixel")) result.pixel = pixel_of(object["pixel"]);
    if (object.contains("depth")) result.depth = beside_polygons(object["depth"], count, "depth", plane_of);
    if (object.contains("areas"))
        result.areas = beside_polygons(object["areas"], count, "areas", fraction_of);
    if (object.contains("background")) result.background = fraction_of(object["background"], "background");
}

std::string number_text(double value) {
    if (value == 0) return std::signbit(value) ? "-0.0" : "0";
    return fmt::format("{:.17g}", value);
}

std::string point_text(Point p) {
    return array_text(std::array{p.x, p.y}, number_text);
}

std::string attributes_text(const PixelCase& pixel_case, const std::string& polygons) {
    const auto plane_text = [](const DepthPlane& plane) {
        return array_text(std::array{plane.a, plane.b, plane.c}, number_text);
    };
    const PixelIndex pixel = pixel_case.pixel;
    std::string text =
        fmt::format("\"id\": {}, \"pixel\": [{}, {}]", json_text(pixel_case.id), pixel.x, pixel.y) + polygons;
    if (pixel_case.depth) text += ", \"depth\": " + array_text(*pixel_case.depth, plane_text);
    if (pixel_case.areas) text += ", \"areas\": " + array_text(*pixel_case.areas, json_text);
    if (pixel_case.background) text += ", \"background\": " + json_text(*pixel_case.background);
    return text;
}

std::size_t lines_between(std::string_view text, std::size_t begin, std::size_t end) {
    return static_cast<std::size_t>(std::ranges::count(text.substr(begin, end - begin), '\n'));
}

}  // namespace keikan::cases
