// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/model/pixel.hpp"
#include "keikan/model/point.hpp"

namespace keikan {

/// Area and first moments of a region within the unit square, or an edge's contribution to them.
struct Moments {
    double area = 0;
    double x = 0;  ///< integral of x over the region
    double y = 0;

    Moments& operator+=(const Moments& m) {
        area += m.area;
        x += m.x;
        y += m.y;
        return *this;
    }
    Moments& operator-=(const Moments& m) {
        area -= m.area;
        x -= m.x;
        y -= m.y;
        return *this;
    }
};

/// What the edge p -> q (image coordinates) contributes to the part of its polygon that lies in the pixel, in
/// coordinates whose origin is the pixel's corner:
///   area = integral of clamp(x, 0, 1) dy,  x = integral of clamp(x, 0, 1)^2 / 2 dy,
///   y = integral of y clamp(x, 0, 1) dy,   each over the part of the edge with 0 <= y <= 1.
/// Summed over all edges of a polygon that is Green's theorem for polygon and square at once: nothing needs
/// to be clipped, and two polygons at an edge get contributions that cancel.
///
/// Properties:
///   (1) The edge q -> p contributes exactly the negative.
///
/// Error: 4 u (u = 2^-53) in `area`, for edges of any length: crossings with the square's borders are worked
///        out in double-double where the edge is longer than a pixel, and then err by one rounding.
Moments edge_moments(Point p, Point q, PixelIndex pixel);

/// The same, more cheaply, for an edge that does not meet the pixel's interior: within the pixel's rows it
/// lies on the left of the pixel, which contributes nothing, or on the right of it.
Moments edge_moments_beside(Point p, Point q, PixelIndex pixel, bool on_the_right);

/// Whether the edge's bounding box, and with it the edge, misses the pixel's interior; exact.
bool box_misses_pixel(Point p, Point q, PixelIndex pixel);

/// The side of the pixel on which an edge lies that does not meet it, when the pixel is on the edge's inner
/// side: the inner side of an edge that runs with rising y is the one of smaller x if its face turns from +x
/// towards +y (`turn` > 0).
inline bool is_right_of_what_is_inside(Point p, Point q, int turn) {
    return turn > 0 ? q.y > p.y : q.y < p.y;
}

}  // namespace keikan
