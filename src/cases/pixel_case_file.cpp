// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/pixel_case_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "case_json.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

using namespace cases;

Ring convex_ring_of(const Json& value, const std::string& where) {
    Ring ring;
    for (const Json& point : array_of(value, where)) {
        const std::string at = fmt::format("{}[{}]", where, ring.size());
        array_of(point, 2, "coordinates", at);
        ring.push_back({number(point[0], at + "[0]"), number(point[1], at + "[1]")});
    }
    return convex(std::move(ring), where);
}

PixelCase case_of(const Json& line, long line_number) {
    if (!line.is_object()) throw BadCase("a pixel case is a JSON object");
    if (!line.contains("polygons")) throw BadCase("has no \"polygons\"");
    PixelCase result;
    for (const Json& polygon : array_of(line["polygons"], "polygons"))
        result.polygons.push_back(
            convex_ring_of(polygon, fmt::format("polygons[{}]", result.polygons.size())));
    read_attributes(line, std::to_string(line_number), result);
    return result;
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
    const auto ring_text = [](const Ring& ring) { return array_text(ring, point_text); };
    const std::string polygons = array_text(pixel_case.polygons, ring_text);
    return fmt::format("{{{}}}", attributes_text(pixel_case, fmt::format(", \"polygons\": {}", polygons)));
}

}  // namespace keikan
