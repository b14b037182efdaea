// SPDX-License-Identifier: Apache-2.0
#include "keikan/scan/seen_face.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "camera_space.hpp"

namespace keikan {
namespace {

/// Newell's sum over the corners, taken from the first: twice the face's area along its normal.
glm::dvec3 area_vector(const Mesh& mesh, std::span<const std::uint32_t> corners) {
    const glm::dvec3 origin = mesh.positions[corners[0]];
    glm::dvec3 sum(0, 0, 0);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        sum += glm::cross(mesh.positions[corners[k]] - origin, mesh.positions[corners[k + 1]] - origin);
    return sum;
}

/// A vector field that is affine on the screen: value + along_x (x - x0) + along_y (y - y0).
struct ScreenAffine {
    glm::dvec3 value, along_x, along_y;
};

/// The corners' normals as a field on the screen, with (x0, y0) = `at`. Nothing where the plane of the first
/// three corners passes through the eye.
std::optional<ScreenAffine> smooth_normal(const Mesh& mesh, std::span<const std::uint32_t> corners,
                                          const Camera& camera, Point at) {
    // Homogeneous screen positions, the image point times its weight, relative to `at` and in units of the
    // focal length. Column i of G * positions = normals: a linear map, hence affine on the screen.
    glm::dmat3 positions, normals;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t corner = corners[static_cast<std::size_t>(i)];
        const CameraPoint p = camera_point(camera, mesh.positions[corner]);
        const double weight = camera.kind == Camera::Kind::Perspective ? p.depth : 1;
        positions[i] = {p.u - (at.x - camera.centre_x) / camera.focal_px * weight,
                        p.v - (at.y - camera.centre_y) / camera.focal_px * weight, weight};
        normals[i] = glm::dvec3(mesh.normals[corner]);
    }
    const double determinant = glm::determinant(positions);
    if (determinant == 0) return std::nullopt;
    const glm::dmat3 field = normals * glm::inverse(positions);
    return ScreenAffine{field[2], field[0] / camera.focal_px, field[1] / camera.focal_px};
}

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::array<float, 3> floats(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

SeenFace seen_face(const ProjectedFaces& faces, std::uint32_t index, const Geometry& geometry,
                   std::uint16_t object, const Camera& camera) {
    const FaceView view = faces[index];
    const Mesh& mesh = geometry.objects[object].mesh;
    const std::uint32_t face = view.id - geometry.first_face[object];
    const auto corners = mesh.face(face);

    SeenFace seen;
    seen.id = view.id;
    seen.object = object;
    seen.material = mesh.face_material[face];
    seen.plane = view.depth;
    seen.normal_at = view.outline[0];

    glm::dvec3 flat = area_vector(mesh, corners);
    const double length = glm::length(flat);
    flat = length > 0 ? flat / length : -camera.forward;
    const glm::dvec3 sight = camera.kind == Camera::Kind::Perspective
                                 ? mesh.positions[corners[0]] - camera.position
                                 : camera.forward;
    if (glm::dot(flat, sight) > 0) flat = -flat;
    seen.flat_normal = floats(flat);
    seen.normal[0] = seen.flat_normal;
    if (mesh.normals.empty()) return seen;

    const auto smooth = smooth_normal(mesh, corners, camera, seen.normal_at);
    if (!smooth) return seen;
    // Any positive factor keeps the direction: one that brings the values near 1 suits floats. The side is
    // judged by the mean of the corners' normals, in which no single one at a silhouette decides.
    glm::dvec3 mean(0, 0, 0);
    for (int i = 0; i < 3; ++i) mean += glm::dvec3(mesh.normals[corners[static_cast<std::size_t>(i)]]);
    const double scale = (glm::dot(mean, flat) < 0 ? -1.0 : 1.0) / glm::length(smooth->value);
    const glm::dvec3 value = smooth->value * scale;
    const glm::dvec3 along_x = smooth->along_x * scale;
    const glm::dvec3 along_y = smooth->along_y * scale;
    if (!finite(value) || !finite(along_x) || !finite(along_y)) return seen;
    seen.normal = {floats(value), floats(along_x), floats(along_y)};
    return seen;
}

}  // namespace keikan
