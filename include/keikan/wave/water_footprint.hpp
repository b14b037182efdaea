// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace keikan {

/// A view ray; `direction` need not have unit length.
struct ViewRay {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

/// What a pixel sees of the mean water plane: a convex polygon, or nothing.
struct WaterFootprint {
    std::array<glm::dvec2, 5> corners{};  ///< in the order of the pixel's corners; a cut may add one
    int count = 0;
    bool reaches_horizon = false;  ///< something was cut away

    std::span<const glm::dvec2> outline() const { return {corners.data(), static_cast<std::size_t>(count)}; }
    /// Mean of the corners; the origin for nothing.
    glm::dvec2 centre() const;
    /// L: the largest extent along a direction (unit vector) [m]; 0 for nothing.
    double extent_m(glm::dvec2 direction) const;
};

/// The footprint on the plane z = 0 of the pixel whose corners have these rays, in order around it. What lies
/// farther along its ray than `farthest` (in units of the rays' own directions) is cut away along a straight
/// line of the image, and so is what lies above the horizon.
///
/// Requires: origins and directions are affine over the pixel (those of a perspective or orthographic camera
///           without normalising); origins above the plane.
/// Exact:    but for rounding: projection maps the edges of the pixel to straight lines, so the corners are
/// enough. Paper:    section 4.2, Fig. 7.
WaterFootprint water_footprint(const std::array<ViewRay, 4>& corners, double farthest);

}  // namespace keikan
