// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "keikan/model/pixel.hpp"
#include "keikan/model/point.hpp"

namespace keikan::oracle {

/// The convex hull of `outline`, strictly convex, counter-clockwise (with y upwards), into `ring`; empty
/// where it has no area. Exact. An outline that is strictly convex already, as nearly all are, is only looked
/// at once.
void convex_outline(std::span<const Point> outline, std::vector<Point>& ring);

/// Where the pixel certainly lies, seen from an edge. A filter: it may not know.
enum class PixelSide { Unknown, Left, Right };

/// Left: no point of the pixel is right of p q. Right: no point of its interior is left of p q.
PixelSide pixel_side(Point p, Point q, PixelIndex pixel);

}  // namespace keikan::oracle
