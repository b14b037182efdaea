// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "peers/contestant.hpp"

namespace keikan::peers::test {

/// The rectangle from (x0, y0) to (x1, y1).
inline Ring box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// `count` cases "half/1/0", "half/1/1" and so on: in case i, one polygon that covers the left half of
/// pixel (i, 0). The truth is 1/2 and 1/2.
std::vector<PixelCase> half_covered_pixels(int count);

/// A peer that answers half_covered_pixels, but for what `misbehave` does at pixel i: it may change the
/// answer, throw, crash or never return.
Peer planted_peer(const std::function<void(int i, Answer& answer)>& misbehave);

}  // namespace keikan::peers::test
