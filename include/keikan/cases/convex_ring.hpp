// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "keikan/model/point.hpp"

namespace keikan {

/// Whether `ring` is a convex polygon, of either orientation, that goes round once. Consecutive equal points
/// count as one, corners of 180 degrees are allowed, and so is a ring without area that keeps to one line.
/// A ring that goes round twice, a star, a bow-tie and a spike are not convex.
///
/// Requires: finite coordinates.
/// Exact:    only signs of orient2d and comparisons of the doubles given.
bool is_convex_ring(std::span<const Point> ring);

}  // namespace keikan
