// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/model/pixel.hpp"
#include "keikan/model/point.hpp"

namespace keikan::clip {

/// A set of borders or of corners of a pixel, as in EdgeView.
using FourSet = unsigned;
constexpr FourSet kAllFour = 15;
constexpr FourSet bit_if(bool member, unsigned k) {
    return static_cast<FourSet>(member) << k;
}
/// Bit k of the result: bit k + 1 of `set`, around the pixel.
constexpr FourSet next_around(FourSet set) {
    return (set >> 1 | set << 3) & kAllFour;
}

/// The pixel's four border lines in image coordinates, as doubles without error.
struct PixelBorders {
    double left, right, low, high;
    explicit PixelBorders(PixelIndex pixel) : left(pixel.x), right(left + 1), low(pixel.y), high(low + 1) {}

    FourSet beyond(Point p) const {
        return bit_if(p.y < low, 0) | bit_if(p.x > right, 1) | bit_if(p.y > high, 2) | bit_if(p.x < left, 3);
    }
    FourSet on_or_beyond(Point p) const {
        return bit_if(p.y <= low, 0) | bit_if(p.x >= right, 1) | bit_if(p.y >= high, 2) |
               bit_if(p.x <= left, 3);
    }
    Point corner(unsigned k) const { return {k == 1 || k == 2 ? right : left, k >= 2 ? high : low}; }
};

}  // namespace keikan::clip
