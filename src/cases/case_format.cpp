// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/case_format.hpp"

#include <iterator>
#include <memory>

#include "keikan/cases/geojson.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/cases/wkt.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

/// A reader of a whole text, and the text that it looks at.
template <typename Reader>
std::function<std::optional<PixelCase>()> whole_text_reader(std::istream& in, const std::string& name) {
    struct Reading {
        std::string text;
        std::optional<Reader> reader;
    };
    return [&in, name, reading = std::make_shared<Reading>()] {
        if (!reading->reader) {
            reading->text.assign(std::istreambuf_iterator<char>(in), {});
            if (in.bad()) throw InputError(name, "", "cannot be read");
            reading->reader.emplace(reading->text, name);
        }
        return reading->reader->next();
    };
}

}  // namespace

std::optional<CaseFormat> case_format_named(std::string_view word) {
    if (word == "jsonl") return CaseFormat::PixelCases;
    if (word == "wkt") return CaseFormat::Wkt;
    if (word == "geojson") return CaseFormat::GeoJson;
    if (word == "svg") return CaseFormat::Svg;
    return std::nullopt;
}

std::optional<CaseFormat> case_format_of(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".json") return CaseFormat::GeoJson;
    return ending.empty() ? std::nullopt : case_format_named(std::string_view(ending).substr(1));
}

std::function<std::optional<PixelCase>()> case_reader(std::istream& in, const std::string& name,
                                                      CaseFormat format) {
    KEIKAN_CHECK(format != CaseFormat::Svg, "a drawing is not read back");
    if (format == CaseFormat::Wkt) return whole_text_reader<WktCaseReader>(in, name);
    if (format == CaseFormat::GeoJson) return whole_text_reader<GeoJsonCaseReader>(in, name);
    return [reader = std::make_shared<PixelCaseReader>(in, name)] { return reader->next(); };
}

std::string text_of_case(const PixelCase& pixel_case, CaseFormat format) {
    KEIKAN_CHECK(format != CaseFormat::Svg, "a drawing shows all cases at once");
    if (format == CaseFormat::Wkt) return wkt_from_case(pixel_case) + "\n";
    if (format == CaseFormat::GeoJson) return geojson_from_case(pixel_case) + "\n";
    return pixel_case_line(pixel_case) + "\n";
}

}  // namespace keikan
