// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <limits>

namespace keikan {

/// Standard gravity [m/s2] (CGPM 1901).
inline constexpr double kGravity = 9.80665;

/// Terms of the series that are kept, and the largest there is.
inline constexpr int kStokesOrders = 5;

/// A wave is steeper than any that stands when H / lambda exceeds this times tanh(k d): Miche 1944,
/// "Mouvements ondulatoires de la mer en profondeur constante ou decroissante"; in deep water it is the
/// limit of Michell 1893.
inline constexpr double kBreakingSteepness = 0.142;

/// Stokes' series holds up to this Ursell number H lambda^2 / d^3; beyond, cnoidal theory does
/// (Fenton 1990, "Nonlinear wave theories"; Hedges 1995).
inline constexpr double kLargestUrsellNumber = 40;

/// Depth of water that is deep for every wave.
inline constexpr double kDeepWater = std::numeric_limits<double>::infinity();

/// One train of waves with long crests.
struct StokesWave {
    double amplitude_m = 0;    ///< A: half of the height H from trough to crest
    double length_m = 1;       ///< lambda
    double direction_rad = 0;  ///< where it goes to, from +x towards +y
    double phase_rad = 0;      ///< of the crest: 0 puts one at the origin at time 0
    friend bool operator==(const StokesWave&, const StokesWave&) = default;
};

/// A Stokes wave of one order in water of one depth: eta(theta) = sum of harmonic_m[n - 1] cos(n theta), with
///   theta = k (x cos d + y sin d) - omega t + phase,   k = 2 pi / lambda,   e = k H / 2.
struct StokesSeries {
    std::array<double, kStokesOrders> harmonic_m{};
    double angular_frequency = 0;  ///< omega [rad/s]
};

/// The series of `wave` to `order` (1 is the sine wave of Airy) in water of mean depth `depth_m`. The mean
/// level is 0, and so is the mean current (Euler's).
///
/// In deep water, with t = theta:
///   k eta = e cos t + 1/2 e^2 cos 2t + 3/8 e^3 (cos 3t - cos t) + 1/3 e^4 (cos 2t + cos 4t)
///           + e^5 / 384 (-422 cos t + 297 cos 3t + 125 cos 5t)
///   omega^2 = g k (1 + e^2 + e^4/2), here as (1 + e^2/2 + e^4/8)^2, which differs by e^6/8 + e^8/64
/// Order n keeps the terms up to e^n of eta, and up to e^(n-1) of omega.
///
/// Errors: InputError (reason only) for numbers out of range, for a wave beyond the breaking limit, and for
///         orders above 1 in water too shallow for the series.
/// Error:  the remainder is O(e^(order+1)): in deep water at order 5, k eta is off by 1.8e-6 at e = 0.1 and
/// by
///         2.5e-3 at e = 0.3 (tests/wave, against numerically exact waves).
/// Paper:  section 4.1. Series: Fenton 1985, "A fifth-order Stokes theory for steady waves", table 1.
StokesSeries stokes_series(const StokesWave& wave, int order, double depth_m = kDeepWater);

/// Wave number k of a sine wave of this angular frequency: omega^2 = g k tanh(k d).
double wave_number(double angular_frequency, double depth_m);

}  // namespace keikan
