// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/image/image.hpp"
#include "keikan/wave/wave_surface.hpp"

namespace keikan {

/// Water that is drawn by rays: waves on its mean plane, and light that goes into it.
struct WaterSurface {
    WaveSurface waves;
    double level_m = 0;           ///< of the mean plane
    double depth_m = kDeepWater;  ///< of the bed below it, where no face is nearer
    double ripple_variance =
        5e-4;  ///< mean square slope, along x and y together, of what is smaller than `waves`
    Rgb absorption_per_m{0.34f, 0.0565f, 0.0092f};  ///< pure water at 650, 550, 450 nm (Pope, Fry 1997)
    Rgb scattering_per_m{0.02f, 0.02f, 0.02f};      ///< as if it were the same in all directions
    Rgb bed{0.25f, 0.22f, 0.16f};                   ///< albedo of the bed at depth_m
};

}  // namespace keikan
