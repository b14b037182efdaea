// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/render/render_bands.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scene/camera.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan::baseline {

/// What every comparison method is given: the projected faces of the picture, as the scan gets them, and
/// which of them may be seen in each band of kBandRows rows (by bounding boxes).
///
/// Requires: geometry and faces outlive it.
/// Cost:     linear in the faces and in the bands that they meet.
class FacesInView {
  public:
    FacesInView(const Geometry& geometry, const ProjectedFaces& faces, const Camera& camera);

    const Geometry& geometry() const { return geometry_; }
    const ProjectedFaces& faces() const { return faces_; }
    const Camera& camera() const { return camera_; }
    /// Faces whose bounding box meets the rows from `first_row` on, a multiple of kBandRows; rising.
    std::span<const std::uint32_t> of_band(int first_row) const;
    std::uint16_t object(std::uint32_t face) const { return object_[face]; }
    bool is_water(std::uint32_t face) const {
        return geometry_.objects[object_[face]].kind == ObjectKind::Water;
    }

  private:
    const Geometry& geometry_;
    const ProjectedFaces& faces_;
    Camera camera_;
    std::vector<std::uint16_t> object_;  ///< of each face
    std::vector<std::uint32_t> begin_;   ///< bands + 1 values, into in_band_
    std::vector<std::uint32_t> in_band_;
};

}  // namespace keikan::baseline
