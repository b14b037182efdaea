// SPDX-License-Identifier: Apache-2.0
#include "wire_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace keikan {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMostTurn = 10 * kDegree;    ///< of the view around a piece
constexpr double kMostBend = 2.5 * kDegree;   ///< of the wire within half a piece

/// How one segment of the axis is to be drawn.
struct Look {
    std::size_t level = 0;
    double slope_rad = 0;
    double view_rad = 0;        ///< direction to the eye, around the wire
    glm::dvec3 to_eye{0, 0, 1};  ///< unit
};

glm::dvec3 direction_to_eye(const Camera& camera, glm::dvec3 point) {
    return camera.kind == Camera::Kind::Perspective ? glm::normalize(camera.position - point) : -camera.forward;
}

Look look_at(const Camera& camera, glm::dvec3 p, glm::dvec3 q, glm::dvec3 along, double diameter_m) {
    const glm::dvec3 across = glm::cross(along, glm::dvec3(0, 0, 1));
    Look look;
    const double diameter_px =
        diameter_m * std::max(pixels_per_metre(camera, p), pixels_per_metre(camera, q));
    while (look.level + 1 < kWireLevels.size() && diameter_px < kWireLevels[look.level].from_diameter_px) ++look.level;
    look.slope_rad = std::atan2(q.z - p.z, glm::dot(q - p, along));
    look.to_eye = direction_to_eye(camera, (p + q) / 2.0);
    look.view_rad = std::atan2(look.to_eye.z, glm::dot(look.to_eye, across));
    return look;
}

bool belongs_to_piece(const Look& first, const Look& next) {
    return next.level == first.level && std::abs(next.slope_rad - first.slope_rad) <= 2 * kMostBend &&
           std::abs(std::remainder(next.view_rad - first.view_rad, 2 * std::numbers::pi)) <= kMostTurn;
}

/// One closed prism: the same section, in a vertical plane across the span, at every point of the axis. Its
/// height is stretched by the slope, so that the wire is round across its own direction; two of its corners lie
/// where the viewer sees its outline.
void add_prism(Mesh& mesh, std::span<const glm::dvec3> axis, glm::dvec3 along, const Look& look, int sides,
               double diameter_m, std::uint16_t material) {
    const glm::dvec3 up{0, 0, 1};
    const glm::dvec3 across = glm::cross(along, up);
    const double stretch = 1 / std::cos(look.slope_rad);
    const auto n = static_cast<std::uint32_t>(sides);
    std::vector<glm::dvec3> spoke(n);
    std::vector<glm::vec3> normal(n);
    for (std::uint32_t k = 0; k < n; ++k) {
        const double angle = look.view_rad + (0.5 + 2.0 * k / n) * std::numbers::pi;
        const glm::dvec3 round = across * std::cos(angle) + up * std::sin(angle);
        spoke[k] = diameter_m / 2 * (across * std::cos(angle) + up * (std::sin(angle) * stretch));
        normal[k] = glm::vec3(round);
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& point : axis)
        for (std::uint32_t k = 0; k < n; ++k) {
            mesh.add_position(point + spoke[k]);
            mesh.normals.push_back(normal[k]);
        }
    // across x up is against the direction of travel, so rising angles turn clockwise for one who looks back.
    const auto segments = static_cast<std::uint32_t>(axis.size() - 1);
    for (std::uint32_t s = 0; s < segments; ++s)
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t here = first + s * n + k, beside = first + s * n + (k + 1) % n;
            mesh.add_face(std::array{here, here + n, beside + n, beside}, material);
        }
    std::vector<std::uint32_t> cap(n);
    for (std::uint32_t k = 0; k < n; ++k) cap[k] = first + k;
    mesh.add_face(cap, material);
    for (std::uint32_t k = 0; k < n; ++k) cap[k] = first + segments * n + (n - 1 - k);
    mesh.add_face(cap, material);
}

/// A strip of parallelograms, as wide as the wire and across the direction of view.
void add_ribbon(Mesh& mesh, std::span<const glm::dvec3> axis, glm::dvec3 along, const Look& look, double diameter_m,
                std::uint16_t material) {
    const glm::dvec3 tangent = along * std::cos(look.slope_rad) + glm::dvec3(0, 0, std::sin(look.slope_rad));
    const glm::dvec3 sideways = glm::cross(tangent, look.to_eye);
    const double length = glm::length(sideways);
    if (length < 1e-6) return;  // seen end on, within a micron per metre: its section, a point of the neighbours
    const glm::dvec3 offset = sideways * (diameter_m / 2 / length);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& point : axis) {
        mesh.add_position(point - offset);
        mesh.add_position(point + offset);
    }
    for (std::uint32_t s = 0; s + 1 < axis.size(); ++s) {
        const std::uint32_t a = first + 2 * s;
        mesh.add_face(std::array{a, a + 2, a + 3, a + 1}, material);
    }
}

}  // namespace

double pixels_per_metre(const Camera& camera, glm::dvec3 point) {
    if (camera.kind == Camera::Kind::Orthographic) return camera.focal_px;
    // Off the axis the image plane stretches by up to distance / depth twice; behind the camera nothing is seen.
    const glm::dvec3 to_point = point - camera.position;
    const double depth = std::max(glm::dot(camera.forward, to_point), camera.near_m);
    const double distance = std::max(glm::length(to_point), camera.near_m);
    return camera.focal_px / std::max(std::min(depth, distance), 0.05 * distance);
}

void add_wire(WireMeshes& meshes, std::span<const glm::dvec3> axis, glm::dvec3 along, double diameter_m,
              std::uint16_t material, const Camera& camera) {
    for (std::size_t begin = 0; begin + 1 < axis.size();) {
        Look first = look_at(camera, axis[begin], axis[begin + 1], along, diameter_m);
        std::size_t end = begin + 1;
        Look last = first;
        while (end + 1 < axis.size()) {
            const Look next = look_at(camera, axis[end], axis[end + 1], along, diameter_m);
            if (!belongs_to_piece(first, next)) break;
            last = next;
            ++end;
        }
        first.slope_rad = (first.slope_rad + last.slope_rad) / 2;
        first.view_rad += std::remainder(last.view_rad - first.view_rad, 2 * std::numbers::pi) / 2;
        first.to_eye = direction_to_eye(camera, axis[(begin + end) / 2]);
        const std::span<const glm::dvec3> piece = axis.subspan(begin, end - begin + 1);
        const int sides = kWireLevels[first.level].sides;
        const std::size_t before = meshes.prisms.face_count() + meshes.ribbons.face_count();
        if (sides > 0)
            add_prism(meshes.prisms, piece, along, first, sides, diameter_m, material);
        else
            add_ribbon(meshes.ribbons, piece, along, first, diameter_m, material);
        meshes.facets[first.level] += meshes.prisms.face_count() + meshes.ribbons.face_count() - before;
        begin = end;
    }
}

}  // namespace keikan
