// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"
#include "keikan/model/pixel_case.hpp"
#include "keikan/model/point.hpp"

namespace keikan::peers {

/// A pixel case, ready to be asked: as it is, and as every author of a polygon library would wish to get it.
/// A view into the case.
struct PreparedPixel {
    PixelIndex pixel;
    Nearness nearness = Nearness::InOrder;
    std::vector<FaceView> faces;
    /// Each face's part of the pixel, pixel-local: strictly convex by exact signs, from +x towards +y, in
    /// [0, 1] x [0, 1], no point twice; empty where it has no area. Clipped in rational arithmetic and then
    /// rounded, so no peer is blamed for an edge a million pixels long: the rounding moves an area by less
    /// than 1e-15.
    std::vector<Ring> in_pixel;
};

PreparedPixel prepared_pixel(const PixelCase& pixel_case);

/// `ring` cut to the unit square at `pixel`, as PreparedPixel::in_pixel says.
Ring ring_in_pixel(std::span<const Point> ring, PixelIndex pixel);

}  // namespace keikan::peers
