// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "keikan/scan/scan_band.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

/// Adds to `light[o]` the luminance (ITU-R BT.709) of object o in the picture, integrated over the rows of
/// `band`, in pixels: for each part of each pixel its weight times that of its colour, as shade_band takes
/// it.
///
/// Requires: light.size() is more than every object of the band.
void add_object_light(const ScanBand& band, const Scene& scene, std::span<double> light);

}  // namespace keikan
