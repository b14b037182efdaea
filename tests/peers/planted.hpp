// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "peers/contestant.hpp"

namespace keikan::peers::test {

/// `count` cases "half/1/0", "half/1/1" and so on: in case i, one polygon that covers the left half of
/// pixel (i, 0). The truth is 1/2 and 1/2.
std::vector<PixelCase> half_covered_pixels(int count);

/// A peer that answers half_covered_pixels, but for what `misbehave` does at pixel i: it may change the
/// answer, throw, crash or never return.
Peer planted_peer(const std::function<void(int i, Answer& answer)>& misbehave);

}  // namespace keikan::peers::test
