// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmpxx.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coverage_picture.hpp"
#include "keikan/cases/polygon.hpp"
#include "keikan/model/point.hpp"

namespace keikan::truth {

/// A sheet of polygons in the plane: it covers what any of its polygons covers. Of one polygon, a point
/// belongs to it if a ray from it meets its rings an odd number of times: of a valid polygon, inside the
/// outline and outside its holes. Rings may touch and cross; repeated points and rings without area change
/// nothing.
struct Layer {
    std::string name;
    std::vector<Polygon> polygons;
};

/// The part of the plane that is the picture: `from` is the outer corner of the first pixel of the first row,
/// `to` that of the last pixel of the last row. Where y grows upwards, as on maps, `from` has the larger y.
/// Requires: from.x != to.x, from.y != to.y.
struct Window {
    Point from;
    Point to;
};

/// The exact visible coverage of every pixel by every layer, the first being the nearest, each rounded once.
///
/// All coordinates are taken as exactly the doubles that they are; corners, cuts and areas are rational
/// numbers. The layers are laid over each other in one exact arrangement of all their segments (CGAL), and
/// the border of each visible region is followed through the grid of pixels by Green's theorem.
///
/// Properties:
///   (1) The coverages of a pixel by all layers and its background add up to 1, exactly, before they are
///   rounded. (2) Their sum over all pixels is the area of what is visible of the layer in the window, in
///   pixels, exactly. (3) The same for any number of threads.
/// `exact`, if given, is told every coverage that is not 0, by rising row, column and layer, the background
/// (Share::kBackground) last.
/// Errors: CheckFailure if (1) does not hold, which would be a mistake of ours. InputError where coordinates
/// are so many powers of two apart that the product of four of them is no double, and CGAL gives up.
CoveragePicture layer_coverage(
    std::span<const Layer> layers, const Window& window, ImageSize size,
    const std::function<void(PixelIndex, std::uint32_t layer, const mpq_class&)>& exact = nullptr);

}  // namespace keikan::truth
