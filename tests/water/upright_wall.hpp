// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/scene/mesh.hpp"

namespace keikan::test {

/// One upright rectangle as an object: x from -half_width to half_width, at this y, z from low to high.
inline Geometry upright_wall(double half_width, double y, double low, double high) {
    Mesh mesh;
    for (const glm::dvec3 p : {glm::dvec3(-half_width, y, low), glm::dvec3(half_width, y, low),
                               glm::dvec3(half_width, y, high), glm::dvec3(-half_width, y, high)})
        mesh.add_position(p);
    const std::uint32_t corners[] = {0, 1, 2, 3};
    mesh.add_face(corners, 0);
    Geometry geometry;
    geometry.objects.push_back({"wall", ObjectKind::Building, mesh});
    geometry.first_face = {0, 1};
    return geometry;
}

}  // namespace keikan::test
