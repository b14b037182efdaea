// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/clip/convex_hull.hpp"
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

/// How much of a pixel a face covers, apart from what hides it.
enum class Overlap { Nothing, Part, WholePixel };

/// Where a corner of an outline and the edge that starts there lie relative to the pixel. As sets:
/// borders of the pixel, bit 0 to 3: y = 0, x = 1, y = 1, x = 0 (border k runs from corner k to corner k +
/// 1); corners of the pixel, bit 0 to 3: (0,0), (1,0), (1,1), (0,1).
struct EdgeView {
    std::uint8_t beyond = 0;   ///< borders beyond which the starting point lies
    std::uint8_t inside = 0;   ///< corners strictly inside the edge
    std::uint8_t outside = 0;  ///< corners strictly outside; one on the line is in neither set
};

/// Compares bounding boxes only: false if the outline certainly has no area in the pixel.
bool may_overlap(PixelIndex pixel, std::span<const Point> outline);

/// Classifies the outline by exact comparisons, which it appends to `views`, one for each edge. WholePixel:
/// no part of the pixel is outside. Part: the outline may yet only touch the pixel.
Overlap overlap(PixelIndex pixel, const ConvexOutline& outline, std::vector<EdgeView>& views);

/// The part of the outline in the pixel, pixel-local, as an exactly strictly convex ring that turns from +x
/// towards +y and starts at its smallest x (then y). Empty if nothing with area is left.
/// The ring is in `scratch`, until the next call with the same scratch.
///
/// Error: every coordinate is within 3/4 * 2^-53 of the exact one: it was rounded to a double below 1 and
///        then snapped. Corners that this makes coincide or line up are removed.
/// Exact: which edges meet which borders, and which corners of the pixel are inside.
std::span<const Point> clip_to_pixel(PixelIndex pixel, const ConvexOutline& outline,
                                     std::span<const EdgeView> views, std::vector<Point>& scratch);

}  // namespace keikan::clip
