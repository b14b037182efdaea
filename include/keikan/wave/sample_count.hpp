// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/wave/water_footprint.hpp"
#include "keikan/wave/wave_surface.hpp"

namespace keikan {

/// The paper's constants and what bounds them (4.2, 4.4, section 5).
struct PaperSampleCounts {
    double k_w = 800;
    double k_r = 3;
    int least = 2;      ///< one mirrored pair
    int most = 65'536;  ///< Eq. (1) grows without end towards the horizon
};

/// Equation (1): N = k_w sum A_i n_i with n_i = L_i / lambda_i, A_i the amplitude in metres, L_i the
/// footprint's extent along wave i, lambda_i its length; rounded to nearest and held between `least` and
/// `most`. Paper: section 4.2. Departure D11: the bounds, which the paper does not state.
int paper_first_count(const WaveSurface& waves, const WaterFootprint& footprint,
                      const PaperSampleCounts& counts);

/// Equation (3): N' = k_r log10 I_v, I_v the largest variance of R, G and B in 8-bit units over the first
/// samples; rounded to nearest; 0 where it is negative or I_v is 0; at most `most`. Paper: section 4.4.
int paper_second_count(double largest_variance, const PaperSampleCounts& counts);

}  // namespace keikan
