// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/clip/ring_difference.hpp"

namespace keikan::test {

/// The area that the rings enclose, each by its sign.
inline double area_of(const SignedRings& rings) {
    double sum = 0;
    for (std::size_t i = 0; i < rings.size(); ++i)
        sum += rings.sign(i) * twice_signed_area(rings.ring(i)) / 2;
    return sum;
}

}  // namespace keikan::test
