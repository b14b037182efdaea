// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "keikan/model/pixel_case.hpp"

namespace keikan {

/// The kinds of files that hold pixel cases.
enum class CaseFormat { PixelCases, Wkt, GeoJson, Svg };

/// "jsonl", "wkt", "geojson" or "svg"; nothing for any other word.
std::optional<CaseFormat> case_format_named(std::string_view word);

/// By the ending of the name (".json" is GeoJSON); nothing for any other.
std::optional<CaseFormat> case_format_of(const std::filesystem::path& file);

/// Gives the cases of the stream, one at each call, then nothing. Pixel cases are read as they come; the
/// other formats are read whole at the first call. `in` must outlive the function; `name` stands for it in
/// messages.
///
/// Requires: not CaseFormat::Svg.
/// Errors:   InputError, as PixelCaseReader, WktCaseReader, GeoJsonCaseReader.
std::function<std::optional<PixelCase>()> case_reader(std::istream& in, const std::string& name,
                                                      CaseFormat format);

/// The case as one or two whole lines of a file. Requires: not CaseFormat::Svg, which draws all at once.
std::string text_of_case(const PixelCase& pixel_case, CaseFormat format);

}  // namespace keikan
