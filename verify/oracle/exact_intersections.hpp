// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "keikan/model/contact.hpp"
#include "keikan/model/point.hpp"

namespace keikan::oracle {

/// Where the boundary of `subject` meets the boundary of the convex `clip` in a vertex of either or by
/// crossing, and what happens there: the question that the product's classifier answers, asked of exact
/// geometry.
///
/// Another route than the product's: every pair of edges is intersected (CGAL, exact constructions), each
/// edge of the subject is divided at the points found on it, and the exact middle of each part is located in
/// the closed clipper. A turn is a change between a part outside and a part not outside.
///
/// Returns the contacts by subject index, those at a vertex before those inside the edge that starts there,
/// the latter along the edge. `point` is the nearest double of the exact point.
///
/// Requires: consecutive points differ; `clip` is strictly convex and turns from +x towards +y.
std::vector<Contact> exact_intersections(std::span<const Point> subject, std::span<const Point> clip);

}  // namespace keikan::oracle
