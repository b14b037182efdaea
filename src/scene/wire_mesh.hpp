// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "keikan/scene/camera.hpp"
#include "keikan/scene/mesh.hpp"
#include "keikan/scene/power_line.hpp"

namespace keikan {

/// Where the pieces of a wire go, and how many facets each level of kWireLevels got.
struct WireMeshes {
    Mesh prisms;   ///< closed, normals smooth around the wire
    Mesh ribbons;  ///< open, facing the viewer, normals as of the round wire behind them
    std::array<std::size_t, kWireLevels.size()> facets{};
};

/// The most pixels that one metre across can measure anywhere on the segment pq, as far as it is in the
/// picture; outside of it, as many as at the picture's corner. Nearer than 1 m counts as 1 m.
double pixels_per_metre(const Camera& camera, glm::dvec3 p, glm::dvec3 q);

/// From where the eye looks at the straight segment pq, as an angle about it: 0 from the horizontal side
/// (z x along), pi/2 from above. The same for every point of the segment's line. `along` is horizontal.
double view_angle_rad(const Camera& camera, glm::dvec3 p, glm::dvec3 q, glm::dvec3 along);

/// Adds the wire along `axis` as polygons, each segment in the level that it takes for `camera`.
///
/// Joints are mitred in the plane that halves the angle between their segments, so that every face is bounded
/// by lines parallel to its segment and the wire keeps its thickness. Prisms run as long as level and view
/// allow, and end in caps; ribbons are one strip of parallelograms, with two triangles where the strip is
/// turned. Requires: at least two points in one vertical plane; `along` is the horizontal unit vector in it.
void add_wire(WireMeshes& meshes, std::span<const glm::dvec3> axis, glm::dvec3 along, double diameter_m,
              std::uint16_t material, const Camera& camera);

}  // namespace keikan
