// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "keikan/scene/mesh.hpp"

namespace keikan {

/// The cross-section of a straight piece of steel, inside a square of its width.
enum class SteelProfile {
    Square,  ///< the whole square: 6 faces
    Angle,   ///< L: two flanges along two sides of the square, kFlangeShare of the width thick: 10 faces
};
inline constexpr double kFlangeShare = 0.1;

/// Adds a closed straight prism from `from` to `to`, its axis in the middle of the section's square. The
/// section is the same at both ends, so every side is a parallelogram.
///
/// The section's v axis is `outward`, as far as that is across the axis; u = v x axis. An Angle has one
/// flange on the side +v, the other on the side -u, or on +u if `mirrored`. Requires: from != to, `outward`
/// not along the axis, width > 0.
void add_member(Mesh& mesh, SteelProfile profile, glm::dvec3 from, glm::dvec3 to, glm::dvec3 outward,
                double width_m, std::uint16_t material, bool mirrored = false);

/// One ring of a turned body: distance along the axis, and radius (positive).
struct LatheRing {
    double along_m;
    double radius_m;
};

/// Adds a closed body turned about the axis from `from` in the unit direction `axis`, with regular polygons
/// of `sides` corners as rings: trapezoids between rings, whose two ring edges are parallel, and a polygon at
/// each end. Rings come in rising order of along_m, at least two.
void add_lathe(Mesh& mesh, glm::dvec3 from, glm::dvec3 axis, std::span<const LatheRing> rings, int sides,
               std::uint16_t material);

/// Radius of the regular polygon with `sides` corners whose silhouette is, over all directions, as wide as
/// that of a circle of radius 1: by Cauchy the mean width is perimeter / pi.
double radius_of_equal_width(int sides);

}  // namespace keikan
