// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/stokes_wave.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

/// Sum of c[i] s^i.
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double s) {
    double sum = 0;
    for (std::size_t i = N; i-- > 0;) sum = sum * s + c[i];
    return sum;
}

/// Fenton's coefficients of the elevation (B) and of the speed (C), functions of k d alone.
struct FentonCoefficients {
    double b22, b31, b42, b44, b53, b55;
    double c0, c2, c4;
};

FentonCoefficients fenton_coefficients(double kd) {
    // S = sech(2 k d); in deep water S = 0 and coth = 1, and 1 - S loses no digits before kd is about 1e-8.
    const double s = kd > 350 ? 0 : 1 / std::cosh(2 * kd);
    const double coth = 1 / std::tanh(kd);
    const double r = 1 - s, r2 = r * r, r3 = r2 * r, r4 = r2 * r2, r5 = r4 * r, r6 = r3 * r3;
    const double t = 3 + 2 * s, q = 4 + s;
    FentonCoefficients f{};
    f.b22 = coth * (1 + 2 * s) / (2 * r);
    f.b31 = -3 * polynomial<4>({1, 3, 3, 2}, s) / (8 * r3);
    f.b42 = coth * polynomial<6>({6, -26, -182, -204, -25, 26}, s) / (6 * t * r4);
    f.b44 = coth * polynomial<6>({24, 92, 122, 66, 67, 34}, s) / (24 * t * r4);
    f.b53 = 9 * polynomial<9>({132, 17, -2216, -5897, -6292, -2687, 194, 467, 82}, s) / (128 * t * q * r6);
    f.b55 = 5 * polynomial<9>({300, 1579, 3176, 2949, 1188, 675, 1326, 827, 130}, s) / (384 * t * q * r6);
    f.c0 = std::sqrt(std::tanh(kd));
    f.c2 = f.c0 * (2 + 7 * s * s) / (4 * r2);
    f.c4 = f.c0 * polynomial<6>({4, 32, -116, -400, -71, 146}, s) / (32 * r5);
    return f;
}

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
    std::ostringstream reason;
    (reason << ... << parts);
    throw InputError(reason.str());
}

void require_wave(const StokesWave& wave, int order, double depth_m) {
    if (order < 1 || order > kStokesOrders) refuse("a Stokes wave has an order of 1 to 5, not ", order);
    if (!(wave.length_m > 0) || !std::isfinite(wave.length_m))
        refuse("a wave cannot be ", wave.length_m, " m long");
    if (!(wave.amplitude_m >= 0) || !std::isfinite(wave.amplitude_m))
        refuse("a wave cannot have an amplitude of ", wave.amplitude_m, " m");
    if (!std::isfinite(wave.direction_rad) || !std::isfinite(wave.phase_rad))
        refuse("direction and phase of a wave must be finite");
    if (!(depth_m > 0)) refuse("water cannot be ", depth_m, " m deep");
    const double height_m = 2 * wave.amplitude_m;
    const double limit = kBreakingSteepness * std::tanh(2 * std::numbers::pi / wave.length_m * depth_m);
    if (height_m > limit * wave.length_m)
        refuse("a wave of amplitude ", wave.amplitude_m, " m and length ", wave.length_m,
               " m breaks: height by length is ", height_m / wave.length_m, ", the limit ", limit,
               " (Miche 1944)");
    const double ursell = height_m * wave.length_m * wave.length_m / (depth_m * depth_m * depth_m);
    if (order > 1 && ursell > kLargestUrsellNumber)
        refuse("water ", depth_m, " m deep is too shallow for a Stokes wave of amplitude ", wave.amplitude_m,
               " m and length ", wave.length_m, " m: its Ursell number is ", ursell, ", the limit ",
               kLargestUrsellNumber, " (Fenton 1990)");
}

}  // namespace

StokesSeries stokes_series(const StokesWave& wave, int order, double depth_m) {
    require_wave(wave, order, depth_m);
    const double k = 2 * std::numbers::pi / wave.length_m;
    const double e = k * wave.amplitude_m;
    const FentonCoefficients f = fenton_coefficients(k * depth_m);
    const double e2 = order >= 2 ? e * e : 0, e3 = order >= 3 ? e * e * e : 0;
    const double e4 = order >= 4 ? e * e * e * e : 0, e5 = order >= 5 ? e * e * e * e * e : 0;
    StokesSeries series;
    series.harmonic_m = {(e + e3 * f.b31 - e5 * (f.b53 + f.b55)) / k, (e2 * f.b22 + e4 * f.b42) / k,
                         (-e3 * f.b31 + e5 * f.b53) / k, e4 * f.b44 / k, e5 * f.b55 / k};
    const double speed = f.c0 + (order >= 3 ? e * e * f.c2 : 0) + e5 / (e > 0 ? e : 1) * f.c4;
    series.angular_frequency = std::sqrt(kGravity * k) * speed;
    return series;
}

double wave_number(double angular_frequency, double depth_m) {
    const double deep = angular_frequency * angular_frequency / kGravity;
    if (std::isinf(depth_m)) return deep;
    // Newton on k tanh(k d) = deep, from above the root, where the function is convex and rising fast enough
    // that no step leaves the positive numbers; quadratic, so that the last step is below rounding.
    double k = std::max(deep, std::sqrt(deep / depth_m));
    for (int i = 0; i < 50; ++i) {
        const double th = std::tanh(k * depth_m);
        const double step = (k * th - deep) / (th + k * depth_m * (1 - th * th));
        k -= step;
        if (std::abs(step) <= 0x1p-50 * k) break;
    }
    return k;
}

}  // namespace keikan
