// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"
#include "keikan/scene/camera.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan {

/// All faces as the camera sees them: *the question* of every pixel, asked of product and oracle alike.
/// Left out: faces wholly behind the near plane or outside the image, back faces of closed solids and of a
/// terrain above which the camera stands (they cannot be seen), and faces seen edge-on (no area in the
/// image). Faces that cross the near plane are cut there.
struct ProjectedFaces {
    std::vector<Point> points;
    std::vector<std::uint32_t> begin{0};  ///< faces + 1 values, into `points`
    std::vector<FaceId> id;               ///< rising
    std::vector<DepthPlane> plane;

    std::size_t size() const { return id.size(); }
    FaceView operator[](std::size_t i) const {
        return {id[i], std::span(points).subspan(begin[i], begin[i + 1] - begin[i]), plane[i]};
    }
};

/// What becomes of back faces that cannot be seen.
enum class HiddenBacks : std::uint8_t {
    LeftOut,
    Kept,  ///< for whoever checks that they cannot be seen
};

/// Projects the geometry. A vertex that two faces share lands on the same doubles in both.
ProjectedFaces project_faces(const Geometry& geometry, const Camera& camera,
                             HiddenBacks backs = HiddenBacks::LeftOut);

/// Positions in `faces` of those whose bounding box meets the pixel (closed on every side), in rising order.
/// Looks at every face: for single pixels.
std::vector<std::uint32_t> faces_at(const ProjectedFaces& faces, PixelIndex pixel);

}  // namespace keikan
