// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/wkt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "case_json.hpp"
#include "keikan/support/input_error.hpp"
#include "wkt_cursor.hpp"

namespace keikan {

namespace {

using namespace cases;

/// "(x y, x y, ...)", closed.
std::string ring_text(const Ring& ring) {
    std::string text = "(";
    for (const Point p : ring) text += fmt::format("{:.17g} {:.17g}, ", p.x, p.y);
    return text + fmt::format("{:.17g} {:.17g})", ring[0].x, ring[0].y);
}

/// The case of a geometry, and of the comment before it.
PixelCase case_of(std::vector<Polygon>&& polygons, std::string_view attributes, std::size_t line) {
    PixelCase result;
    for (Polygon& polygon : polygons) {
        const std::string where = fmt::format("polygon {}", result.polygons.size());
        if (!polygon.holes.empty()) throw BadCase(where, "has a hole");
        result.polygons.push_back(convex(std::move(polygon.outline), where));
    }
    const Json keys = attributes.empty() ? Json::object() : parsed(attributes);
    read_attributes(keys, std::to_string(line), result);
    return result;
}

}  // namespace

Ring ring_from_wkt(std::string_view text, const std::string& name) {
    WktCursor cursor(text, name, WktCursor::Place::Column);
    if (cursor.word() != "POLYGON") cursor.refuse("expected POLYGON ((x y, x y, ...))");
    Polygon polygon = cursor.polygon();
    if (!polygon.holes.empty()) cursor.refuse("a polygon with holes is not one ring");
    if (!cursor.at_end()) cursor.refuse("something follows the polygon");
    Ring ring;
    for (const Point p : polygon.outline)
        if (ring.empty() || ring.back() != p) ring.push_back(p);
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    return ring;
}

std::string wkt_from_ring(const Ring& ring) {
    return ring.empty() ? "POLYGON EMPTY" : fmt::format("POLYGON ({})", ring_text(ring));
}

std::vector<Polygon> polygons_from_wkt(std::string_view text, const std::string& name) {
    WktCursor cursor(text, name, WktCursor::Place::LineAndColumn);
    std::vector<Polygon> polygons;
    for (cursor.skip_comments(); !cursor.at_end(); cursor.skip_comments())
        std::ranges::move(cursor.geometry(), std::back_inserter(polygons));
    return polygons;
}

template <>
std::optional<PixelCase> WktCaseReader::next() {
    WktCursor cursor(text_, name_, WktCursor::Place::LineAndColumn, at_);
    const std::string_view attributes = cursor.skip_comments();
    if (cursor.at_end()) return std::nullopt;
    line_ += lines_between(text_, at_, cursor.at());
    at_ = cursor.at();
    const std::size_t line = line_;
    std::vector<Polygon> polygons = cursor.geometry();
    line_ += lines_between(text_, at_, cursor.at());
    at_ = cursor.at();
    try {
        return case_of(std::move(polygons), attributes, line);
    } catch (const BadCase& bad) {
        throw InputError(name_, std::to_string(line), bad.what());
    }
}

std::string wkt_from_case(const PixelCase& pixel_case) {
    std::string text = fmt::format("# {{{}}}\nGEOMETRYCOLLECTION ", attributes_text(pixel_case));
    if (pixel_case.polygons.empty()) return text + "EMPTY";
    const char* separator = "(";
    for (const Ring& ring : pixel_case.polygons) {
        text += separator;
        text += wkt_from_ring(ring);
        separator = ", ";
    }
    return text + ")";
}

}  // namespace keikan
