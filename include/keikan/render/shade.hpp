// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/image/image.hpp"
#include "keikan/scan/scan_band.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

class SceneRays;
class WaterPixels;

/// Optional pictures beside the colours; empty images are not made.
struct ExtraImages {
    Image<float> background;     ///< uncovered fraction of the pixel
    Image<float> object_id;      ///< 1 + object of the largest part, 0 for the background
    Image<float> depth;          ///< of the largest part at its centroid [m], 0 for the background
    Image<float> flags;          ///< 0 one face only, 1 divided by exact areas, 2 divided along the scanline
    Image<float> water_samples;  ///< taken for the pixel's water; 0: none is drawn by rays
};

/// Colours the rows of `band` in `image` (linear light): Phong reflection at the centroid of each visible
/// part, area-weighted mean where a pixel is divided. Uses of `scene` the camera, light, background, haze and
/// materials only. Bands touch different rows, so they may be shaded side by side.
///
/// A pixel that shows one face only is shaded at its centre, and so is the background's share of a divided
/// pixel. With the unit normal n of the face there, towards the viewer, l = light.to_sun, r = 2 (n.l) n - l,
/// v the unit vector to the eye, d the distance from the eye:
///   ambient = ground_ambient + (1 + n.z) / 2 (sky_ambient - ground_ambient)
///   phong   = ambient albedo + sun (diffuse albedo max(0, n.l) + specular max(0, r.v)^exponent)
///             (no specular term where n.l <= 0)
///   colour  = phong + (1 - exp(-d / range_m)) (haze.colour - phong)
/// The albedo of a material with a ramp follows the height of the point, and blends to `steep` linearly in
/// the slope angle that n has there: without steps between faces whose vertex normals agree. The background's
/// colour goes from `horizon` (at and below the horizon) to `zenith` linearly in the sine of the view
/// direction's elevation.
///
/// With `rays`, unless Light::shadows is Off, `sun` is that share of it that is seen past other faces
/// (SceneRays::sun_share): from 4 points of the face, spread over the pixel (over a square of the size of a
/// divided pixel's part, around its centroid), and where these do not agree, from 32.
///
/// Pixels that hold water that is drawn by rays (Scene::water) are noted in `water`, and that water adds
/// nothing here; without `water` it is flat colour.
///
/// The largest part of a divided pixel, in ExtraImages, is the background's where that is larger than each
/// face's; of parts of equal size it is the one that stands first.
///
/// Properties:
///   (1) A pixel's colour follows from the band and the scene alone, bit for bit: not from other bands,
///       other pixels or the number of threads.
/// Errors: CheckFailure where a band refers to a material that the scene does not have.
/// Paper:  section 2 (rendering), 3.1 step (6).
void shade_band(const ScanBand& band, const Scene& scene, Image<Rgb>& image, ExtraImages* extra = nullptr,
                WaterPixels* water = nullptr, const SceneRays* rays = nullptr);

}  // namespace keikan
