// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "keikan/model/point.hpp"

namespace keikan {

/// A polygon as maps and drawings have it: an outline, concave or not, and the holes in it. Either
/// orientation; the point that closes a ring in a file is not repeated here.
struct Polygon {
    Ring outline;
    std::vector<Ring> holes;
    friend bool operator==(const Polygon&, const Polygon&) = default;
};

}  // namespace keikan
