// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "keikan/cases/polygon.hpp"
#include "keikan/cases/text_case_reader.hpp"
#include "keikan/model/pixel_case.hpp"

namespace keikan {

/// The polygons of all GeoJSON documents (RFC 7946) in `text`, in their order: Polygon, MultiPolygon, and
/// GeometryCollection, Feature and FeatureCollection of these. Each coordinate is exactly the double that it
/// names; of a position the first two numbers count. Repeated points are kept; only the point that closes a
/// ring is left out. A feature without geometry has no polygon.
///
/// Errors: InputError naming `name`, line and place in the document and the reason: broken JSON, another kind
///         of geometry, a ring that does not end where it begins, a number that is not finite.
std::vector<Polygon> polygons_from_geojson(std::string_view text, const std::string& name);

/// Pixel cases in GeoJSON (docs/cases.md): each document is a case, its polygons nearest first. The document
/// may have the keys of a pixel case other than "polygons" as members; the id defaults to the line.
///
/// Errors: InputError, as polygons_from_geojson and PixelCaseReader; a hole is one, too.
struct GeoJsonText;
using GeoJsonCaseReader = TextCaseReader<GeoJsonText>;
template <>
std::optional<PixelCase> GeoJsonCaseReader::next();

/// The case as a FeatureCollection on one line without its line end, one Feature for each polygon, with 17
/// significant digits. GeoJsonCaseReader reads the same case again, bit for bit.
std::string geojson_from_case(const PixelCase& pixel_case);

}  // namespace keikan
