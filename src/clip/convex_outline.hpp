// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/pixel.hpp"
#include "keikan/model/point.hpp"

namespace keikan::clip {

/// The nearest multiple of 2^-53. Multiples of 2^-53 in [0, 1] are doubles, and so is every difference of
/// two of them: what is computed from differences of snapped coordinates starts without an error.
/// Requires: 0 <= v <= 1.
inline double snap(double v) {
    return v < 0.5 ? (v + 0.5) - 0.5 : v;
}

/// The corners of a strictly convex polygon with area, read so that it turns from +x towards +y.
class ConvexOutline {
  public:
    ConvexOutline() = default;
    ConvexOutline(std::span<const Point> points, bool backwards) : points_(points), backwards_(backwards) {}
    std::size_t size() const { return points_.size(); }
    Point operator[](std::size_t i) const { return points_[backwards_ ? points_.size() - 1 - i : i]; }

  private:
    std::span<const Point> points_;
    bool backwards_ = false;
};

/// Whether `ring` is exactly strictly convex, and which way it turns.
enum class Turning { Positive, Negative, NotStrictlyConvex };
Turning turning(std::span<const Point> ring);

/// Replaces `points` by the corners of their convex hull, exactly: no three on a line, turning from +x
/// towards +y, from the smallest x (then y). Fewer than three remain when the points have no area.
void replace_by_hull(std::vector<Point>& points);

/// How much of a pixel a face covers, apart from what hides it.
enum class Overlap { Nothing, Part, WholePixel };

/// On which side of each edge of an outline the pixel's corners lie. Bit k: corner k, counted (0,0), (1,0),
/// (1,1), (0,1). A corner on the line is in neither set.
struct CornerSides {
    std::uint8_t inside = 0;
    std::uint8_t outside = 0;
};

/// Compares bounding boxes only: false if the outline certainly has no area in the pixel.
bool may_overlap(PixelIndex pixel, std::span<const Point> outline);

/// Classifies the outline by the exact sides of the pixel's corners, which it leaves in `sides`, one for
/// each edge. WholePixel: no part of the pixel is outside. Part: the outline may yet only touch the pixel.
Overlap overlap(PixelIndex pixel, const ConvexOutline& outline, std::vector<CornerSides>& sides);

/// The part of the outline in the pixel, pixel-local, as an exactly strictly convex ring that turns from +x
/// towards +y and starts at its smallest x (then y). Empty if nothing with area is left.
///
/// Error: every coordinate of `ring` is within 3/4 * 2^-53 of the exact one: it was rounded to a double below
///        1 and then snapped. Corners that this makes coincide or line up are removed.
/// Exact: which edges meet which borders, and which corners of the pixel are inside.
void clip_to_pixel(PixelIndex pixel, const ConvexOutline& outline, std::span<const CornerSides> sides,
                   std::vector<Point>& ring);

}  // namespace keikan::clip
