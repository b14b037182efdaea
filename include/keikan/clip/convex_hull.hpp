// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "keikan/model/point.hpp"

namespace keikan::clip {

/// Replaces `points` by the corners of their convex hull, exactly: no three on a line, turning from +x
/// towards +y, from the smallest x (then y). Fewer than three remain when the points have no area.
///
/// Requires: finite coordinates.
/// Exact:    only signs of orient2d and comparisons of the doubles given.
void replace_by_hull(std::vector<Point>& points);

}  // namespace keikan::clip
