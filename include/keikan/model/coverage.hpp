// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "keikan/model/point.hpp"

namespace keikan {

/// What one face shows of itself in one pixel.
struct VisiblePart {
    std::uint32_t face = 0;  ///< position in the list of faces that was asked about
    double area = 0;         ///< fraction of the pixel, in (0, 1]
    Point centroid;          ///< of the visible region, pixel-local
};

/// One pixel, divided among the faces seen in it. Faces that show nothing are left out.
/// A view: it stays valid until the next question to whoever returned it.
struct PixelCoverage {
    std::span<const VisiblePart> parts;  ///< by rising `face`
    double background = 1;               ///< the fraction that no face covers
};

/// One convex piece of a face's visible region; a face may have many.
struct VisiblePiece {
    std::uint32_t face = 0;       ///< position in the list of faces; kBackground for what stays free
    std::span<const Point> ring;  ///< pixel-local
    static constexpr std::uint32_t kBackground = 0xFFFFFFFFu;
};

/// One ring of a face's visible outline: a point is seen as often as the sum of sign times winding number
/// says.
struct VisibleOutline {
    std::uint32_t face = 0;  ///< position in the list of faces; VisiblePiece::kBackground for what stays free
    int sign = 1;            ///< -1: a hole
    std::span<const Point> ring;  ///< pixel-local
};

}  // namespace keikan
