// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace keikan {

/// Two doubles that the processor works on at once (a language extension of g++ and clang).
using TwoDoubles = double __attribute__((vector_size(16)));

/// Sine and cosine of an angle, or of two.
template <typename Real>
struct SineCosine {
    Real sine;
    Real cosine;
};

/// Of 2 pi `turns`, within 2e-15. Uses + - * only and no branch, so compilers work on several angles at once
/// and every machine gives the same bits. Requires: |turns| < 2^50.
template <typename Real>
inline SineCosine<Real> sine_of_turns(Real turns) {
    // Adding and taking away 1.5 * 2^52 rounds to the nearest whole number; the rest is exact.
    constexpr double kRound = 0x1.8p52;
    const Real rest = turns - ((turns + kRound) - kRound);
    // A quarter of the angle, within [-pi/4, pi/4]: Taylor's remainders are below 5e-17.
    const Real a = rest * 1.5707963267948966, q = a * a;
    Real s = q * (-1.0 / 1307674368000.0) + 1.0 / 6227020800.0;
    s = s * q - 1.0 / 39916800.0;
    s = s * q + 1.0 / 362880.0;
    s = s * q - 1.0 / 5040.0;
    s = s * q + 1.0 / 120.0;
    s = s * q - 1.0 / 6.0;
    s = a + a * q * s;
    Real c = q * (1.0 / 20922789888000.0) - 1.0 / 87178291200.0;
    c = c * q + 1.0 / 479001600.0;
    c = c * q - 1.0 / 3628800.0;
    c = c * q + 1.0 / 40320.0;
    c = c * q - 1.0 / 720.0;
    c = c * q + 1.0 / 24.0;
    c = c * q - 1.0 / 2.0;
    c = 1 + q * c;
    // Twice doubled.
    const Real s2 = 2 * s * c, c2 = 1 - 2 * s * s;
    return {2 * s2 * c2, 1 - 2 * s2 * s2};
}

}  // namespace keikan
