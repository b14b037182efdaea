// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/geojson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "case_json.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

using namespace cases;

/// Collections within collections go no deeper; RFC 7946 advises against any nesting.
constexpr int kDeepestCollection = 16;

Point position(const Json& value, const std::string& where) {
    if (array_of(value, where).size() < 2) throw BadCase(where, "has fewer than 2 coordinates");
    return {number(value[0], where + "[0]"), number(value[1], where + "[1]")};
}

Ring ring_of(const Json& value, const std::string& where) {
    Ring ring;
    for (const Json& point : array_of(value, where))
        ring.push_back(position(point, fmt::format("{}[{}]", where, ring.size())));
    if (ring.size() < 2 || ring.front() != ring.back()) throw BadCase(where, "does not end where it begins");
    ring.pop_back();
    return ring;
}

Polygon polygon_of(const Json& value, const std::string& where) {
    Polygon polygon;
    std::size_t count = 0;
    for (const Json& part : array_of(value, where)) {
        Ring ring = ring_of(part, fmt::format("{}[{}]", where, count));
        if (count++ == 0)
            polygon.outline = std::move(ring);
        else
            polygon.holes.push_back(std::move(ring));
    }
    return polygon;
}

const Json& member(const Json& object, const char* key, const std::string& where) {
    if (!object.contains(key)) throw BadCase(where, fmt::format("has no \"{}\"", key));
    return object[key];
}

/// Appends the polygons of a geometry, a feature or a collection. `where` is its place, "document" at the
/// top.
void add_polygons(const Json& object, const std::string& where, int depth, std::vector<Polygon>& out) {
    if (!object.is_object()) throw BadCase(where, "is not a GeoJSON object");
    if (depth > kDeepestCollection) throw BadCase(where, "is nested too deeply");
    const Json& type = member(object, "type", where);
    const std::string kind = type.is_string() ? type.get<std::string>() : "";
    const std::string prefix = depth == 0 ? "" : where + ".";
    const auto add_all = [&](const char* key) {
        const std::string list = prefix + key;
        std::size_t i = 0;
        for (const Json& item : array_of(member(object, key, where), list))
            add_polygons(item, fmt::format("{}[{}]", list, i++), depth + 1, out);
    };
    if (kind == "FeatureCollection") {
        add_all("features");
    } else if (kind == "GeometryCollection") {
        add_all("geometries");
    } else if (kind == "Feature") {
        const Json& geometry = member(object, "geometry", where);
        if (!geometry.is_null()) add_polygons(geometry, prefix + "geometry", depth + 1, out);
    } else if (kind == "Polygon") {
        out.push_back(polygon_of(member(object, "coordinates", where), prefix + "coordinates"));
    } else if (kind == "MultiPolygon") {
        const std::string list = prefix + "coordinates";
        std::size_t i = 0;
        for (const Json& item : array_of(member(object, "coordinates", where), list))
            out.push_back(polygon_of(item, fmt::format("{}[{}]", list, i++)));
    } else {
        throw BadCase(where, "is neither a polygon nor a collection of polygons");
    }
}

/// Documents one after another in a text.
class Documents {
  public:
    explicit Documents(std::string_view text, std::size_t at = 0, std::size_t line = 1)
        : text_(text), at_(at), line_(line) {}

    /// The text of the next document, up to the bracket that closes it; empty at the end. A text that is none
    /// is handed over as it is, for the parser to say what is wrong.
    std::string_view next() {
        line_ += lines_between(text_, begin_, at_);
        begin_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
        line_ += lines_between(text_, at_, begin_);
        at_ = begin_;
        bool in_string = false;
        for (std::size_t depth = 0; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (in_string) {
                at_ += c == '\\' && at_ + 1 < text_.size();
                in_string = c != '"';
                continue;
            }
            in_string = c == '"';
            depth += c == '{' || c == '[';
            if (c != '}' && c != ']') continue;
            if (depth <= 1) {
                ++at_;
                break;
            }
            --depth;
        }
        return text_.substr(begin_, at_ - begin_);
    }
    std::size_t at() const { return at_; }
    /// In which the document handed over begins, counted from 1.
    std::size_t line() const { return line_; }

  private:
    std::string_view text_;
    std::size_t at_;
    std::size_t begin_ = at_;
    std::size_t line_;
};

}  // namespace

std::vector<Polygon> polygons_from_geojson(std::string_view text, const std::string& name) {
    std::vector<Polygon> polygons;
    Documents documents(text);
    for (auto document = documents.next(); !document.empty(); document = documents.next()) try {
            add_polygons(parsed(document), "document", 0, polygons);
        } catch (const BadCase& bad) {
            throw InputError(name, std::to_string(documents.line()), bad.what());
        }
    return polygons;
}

template <>
std::optional<PixelCase> GeoJsonCaseReader::next() {
    Documents documents(text_, at_, line_);
    const std::string_view document = documents.next();
    line_ = documents.line() + lines_between(document, 0, document.size());
    at_ = documents.at();
    if (document.empty()) return std::nullopt;
    try {
        const Json object = parsed(document);
        std::vector<Polygon> polygons;
        add_polygons(object, "document", 0, polygons);
        PixelCase result;
        for (Polygon& polygon : polygons) {
            const std::string where = fmt::format("polygon {}", result.polygons.size());
            if (!polygon.holes.empty()) throw BadCase(where, "has a hole");
            result.polygons.push_back(convex(std::move(polygon.outline), where));
        }
        read_attributes(object, std::to_string(documents.line()), result);
        return result;
    } catch (const BadCase& bad) {
        throw InputError(name_, std::to_string(documents.line()), bad.what());
    }
}

std::string geojson_from_case(const PixelCase& pixel_case) {
    std::size_t count = 0;
    const auto feature = [&](const Ring& ring) {
        Ring closed = ring;
        if (!ring.empty()) closed.push_back(ring[0]);
        return fmt::format(
            R"({{"type": "Feature", "properties": {{"polygon": {}}}, "geometry": {{"type": "Polygon", "coordinates": [{}]}}}})",
            count++, ring.empty() ? "" : array_text(closed, point_text));
    };
    const std::string features = array_text(pixel_case.polygons, feature);
    return fmt::format(R"({{"type": "FeatureCollection", {}, "features": {}}})", attributes_text(pixel_case),
                       features);
}

}  // namespace keikan
