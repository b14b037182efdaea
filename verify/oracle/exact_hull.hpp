// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "keikan/model/point.hpp"

namespace keikan::oracle {

/// For who makes questions: the convex hull of the points by exact signs: its strict corners, bit for bit
/// among the points, turning from +x towards +y. Of points on one line: their two ends; of one point: itself.
/// Requires: finite numbers.
Ring exact_hull(std::span<const Point> points);

}  // namespace keikan::oracle
