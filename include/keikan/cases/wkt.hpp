// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

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

}  // namespace keikan
