// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "keikan/model/pixel.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// Adds a face with this outline in the image and this plane.
void add_face(ProjectedFaces& faces, const Ring& outline, DepthPlane plane);

/// A picture of 8 x 6 pixels with everything in it that a comparison must see: a face that covers pixels
/// whole, one in front of it, a wire, two faces through each other, a hidden face, and sky in the upper row.
struct SmallPicture {
    static constexpr ImageSize kSize{8, 6};
    enum Face : FaceId { Wall, Triangle, Wire, Hidden, RisingRoof, FallingRoof, kFaces };

    Geometry geometry;  ///< two objects; only ids and materials matter here
    ProjectedFaces faces;
    std::vector<ScanBand> bands;  ///< of two rows each, as a scan without mistakes would hand them over

    SmallPicture();

    ScanBand& band_of(int row) { return bands[static_cast<std::size_t>(row) / 2]; }
    /// The divided pixel there. Requires: it is one.
    DividedPixel& divided(PixelIndex pixel);
    /// The span that holds the pixel. Requires: it is in one.
    Span& span(PixelIndex pixel);
    /// The part of a divided pixel that shows this face. Requires: it shows.
    SeenPart& part(PixelIndex pixel, FaceId face);
};

}  // namespace keikan
