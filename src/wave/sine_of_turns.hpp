// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace keikan {

inline constexpr double kTurn = 6.283185307179586;  ///< 2 pi

/// How far sine_of_turns may be from the true values.
inline constexpr double kSineError = 2e-12;

/// Sine and cosine of an angle, or of several.
template <typename Real>
struct SineCosine {
    Real sine;
    Real cosine;
};

/// Of 2 pi `turns`, a number or a vector of them, within kSineError. Uses + - * only and no branch: every
/// machine gives the same bits. Requires: |turns| < 2^50.
template <typename Real>
[[gnu::always_inline]] inline SineCosine<Real> sine_of_turns(Real turns) {
    // Adding and taking away 1.5 * 2^52 rounds to the nearest whole number; the rest is exact.
    constexpr double kRound = 0x1.8p52;
    const Real rest = turns - ((turns + kRound) - kRound);
    // A quarter of the angle, within [-pi/4, pi/4]. Polynomials in its square that interpolate at Chebyshev's
    // nodes: sin(a) / a within 1.8e-14, cos(a) within 2.3e-13; doubling twice makes at most 8 times as much
    // of the latter.
    const Real a = rest * 1.5707963267948966, q = a * a;
    Real s = q * -2.4805636241834762e-08 + 2.755599092956532e-06;
    s = s * q - 1.9841266916985966e-04;
    s = s * q + 8.333333331079223e-03;
    s = s * q - 1.6666666666663885e-01;
    s = a + a * q * s;
    Real c = q * -2.7237140418016e-07 + 2.4799862190148396e-05;
    c = c * q - 1.38888850913992e-03;
    c = c * q + 4.166666663739607e-02;
    c = c * q - 4.999999999996389e-01;
    c = 1 + q * c;
    // Twice doubled.
    const Real s2 = 2 * s * c, c2 = 1 - 2 * s * s;
    return {2 * s2 * c2, 1 - 2 * s2 * s2};
}

}  // namespace keikan
