// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "keikan/cases/polygon.hpp"
#include "keikan/cases/text_case_reader.hpp"
#include "keikan/model/pixel_case.hpp"
#include "keikan/model/point.hpp"

namespace keikan {

/// The ring of a well-known text "POLYGON ((x y, x y, ...))", without its repeated last point. Letters of
/// either case; coordinates decimal or C hexadecimal, each exactly the double it names. Consecutive equal
/// points count as one; a polygon may have any number of points, "POLYGON EMPTY" has none.
///
/// Errors: InputError naming `name`, the column and the reason: another kind of geometry, a second ring (a
///         hole), a number that is not finite, a ring that does not end where it begins.
Ring ring_from_wkt(std::string_view text, const std::string& name);

/// "POLYGON ((x y, ...))" with 17 significant digits, which name the same doubles again.
std::string wkt_from_ring(const Ring& ring);

/// The polygons of all geometries in `text`, in their order: POLYGON, MULTIPOLYGON, and collections of these
/// however nested, one after another with white space or ';' between them. Lines that begin with '#' are
/// skipped. Coordinates as above; repeated points are kept, empty polygons too.
///
/// Errors: InputError naming `name`, line and column and the reason; lines and points are no polygons.
std::vector<Polygon> polygons_from_wkt(std::string_view text, const std::string& name);

/// Pixel cases in well-known text (docs/cases.md): each geometry is a case, its polygons nearest first. A
/// line
/// "# {...}" before it may state the keys of a pixel case other than "polygons"; the id defaults to the line.
///
/// Errors: InputError, as polygons_from_wkt and PixelCaseReader; a hole is one, too.
struct WktText;
using WktCaseReader = TextCaseReader<WktText>;
template <>
std::optional<PixelCase> WktCaseReader::next();

/// The case in two lines: its keys other than "polygons" after "# ", and a GEOMETRYCOLLECTION with 17
/// significant digits. WktCaseReader reads the same case again, bit for bit.
std::string wkt_from_case(const PixelCase& pixel_case);

}  // namespace keikan
