// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "keikan/wave/stokes_wave.hpp"

namespace keikan {

/// H / lambda of a wave of the wind, at most, times tanh(k d): two thirds of kBreakingSteepness.
inline constexpr double kSteepestWindWave = 0.095;

/// Waves that a steady wind has raised over a stretch of water.
struct WindSea {
    double wind_speed_m_s = 5;      ///< 10 m above the water
    double wind_direction_rad = 0;  ///< where it blows to, from +x towards +y
    double fetch_m = 10'000;        ///< how much water it has blown over
    double depth_m = kDeepWater;    ///< changes lengths only; the spectrum is that of deep water
    int count = 40;                 ///< M
    double shortest_m = 0.1;        ///< shorter waves are left out
    std::uint32_t seed = 1;
};

/// M waves whose sum has the spectrum of JONSWAP (Hasselmann et al. 1973), gamma = 3.3, sigma = 0.07 / 0.09:
///   S(w) = alpha g^2 w^-5 exp(-5/4 (w_p/w)^4) gamma^r,   r = exp(-(w - w_p)^2 / (2 sigma^2 w_p^2)),
///   alpha = 0.076 (U^2 / (F g))^0.22,   w_p = 22 (g^2 / (U F))^(1/3), not below 0.855 g / U, the peak of a
///   sea that has stopped growing (Pierson, Moskowitz 1964), where alpha is 0.0081 and gamma 1.
/// Directions spread as cos^2 over the half circle downwind. The frequencies from 0.6 w_p to that of
/// `shortest_m` are cut into `count` bands that share out the spectrum's *slope* (S w^4, integrated) and its
/// height half and half, one wave a band: amplitude sqrt(2 m0 of the band), frequency at random within it,
/// direction and phase at random.
///
/// Properties:
///   (1) The sum of amplitude^2 / 2 is the integral of S over the frequencies that are kept, less what would
///   make a
///       wave steeper than kSteepestWindWave (bands so wide, in so few waves, are no sea).
///   (2) A function of the fields alone: the same seed, the same waves.
/// Errors: InputError (reason only) for numbers out of range, and where `shortest_m` is longer than the
/// wind's waves.
std::vector<StokesWave> wind_sea(const WindSea& sea);

/// Mean square slope of a clean sea, of all waves down to ripples (Cox, Munk 1954): 0.003 + 0.00512 U.
double cox_munk_slope_variance(double wind_speed_m_s);

}  // namespace keikan
