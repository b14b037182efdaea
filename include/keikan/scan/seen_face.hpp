// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// What shading must know of face `index` of `faces`, which belongs to object `object` of the geometry.
///
/// Smooth meshes: vertex normals are linear over the face, so normal/depth (perspective) or the normal
/// (orthographic) is affine on the screen; the affine function goes through corners 0, 1 and 2, also where
/// these lie behind the camera. A face whose plane passes through the eye is shaded flat.
SeenFace seen_face(const ProjectedFaces& faces, std::uint32_t index, const Geometry& geometry,
                   std::uint16_t object, const Camera& camera);

}  // namespace keikan
