// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/image/image.hpp"
#include "keikan/scan/scan_band.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

/// Optional pictures beside the colours; empty images are not made.
struct ExtraImages {
    Image<float> background;       ///< uncovered fraction of the pixel
    Image<float> object_id;        ///< 1 + object of the largest part, 0 for the background
    Image<float> depth;            ///< of the largest part at its centroid [m], 0 for the background
    Image<float> flags;            ///< 0 one face only, 1 divided by exact areas, 2 divided along the scanline
};

/// Colours the rows of `band` in `image` (linear light): Phong reflection at the centroid of each visible part,
/// area-weighted mean where a pixel is divided. Uses of `scene` the camera, light, background, haze and
/// materials only. Bands touch different rows, so they may be shaded side by side.
/// Errors: CheckFailure where a band refers to a material that the scene does not have.
/// Paper:  section 2 (rendering), 3.1 step (6).
void shade_band(const ScanBand& band, const Scene& scene, Image<Rgb>& image, ExtraImages* extra = nullptr);

}  // namespace keikan
