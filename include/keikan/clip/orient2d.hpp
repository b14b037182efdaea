// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/model/point.hpp"

namespace keikan {

/// The answer of a question about a sign.
enum class Sign { Negative = -1, Zero = 0, Positive = 1 };

constexpr Sign operator-(Sign sign) {
    return static_cast<Sign>(-static_cast<int>(sign));
}

/// The side of the line a -> b on which c lies: Positive when a -> b -> c turns from +x towards +y,
/// Zero when the three points lie on one line or two of them coincide.
///
/// Properties:
///   (1) Exchanging two points turns the sign round; a cyclic exchange changes nothing.
///   (2) Multiplying every coordinate with the same power of two changes nothing.
///
/// Requires: finite coordinates.
/// Exact:    for all finite doubles.
/// Cost:     about ten operations; the exact sum is formed only where rounding could hide the sign.
Sign orient2d(Point a, Point b, Point c);

}  // namespace keikan
