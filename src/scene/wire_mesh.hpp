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
    Mesh prisms;   ///< closed
    Mesh ribbons;  ///< open, facing the viewer
    std::array<std::size_t, kWireLevels.size()> facets{};
};

/// Pixels that one metre across measures at `point`, at least as many as anywhere near it.
double pixels_per_metre(const Camera& camera, glm::dvec3 point);

/// Adds the wire along `axis` (points in one vertical plane) as polygons, level by level for `camera`.
/// `along` is the horizontal unit direction of the span. Requires: at least two points.
void add_wire(WireMeshes& meshes, std::span<const glm::dvec3> axis, glm::dvec3 along, double diameter_m,
              std::uint16_t material, const Camera& camera);

}  // namespace keikan
