// SPDX-License-Identifier: Apache-2.0
#include "wire_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace keikan {

namespace {

constexpr double kPi = std::numbers::pi;

/// One segment of the axis: its own frame, and how it is looked at.
struct Segment {
    glm::dvec3 above;  ///< unit vector across the segment in the wire's plane; side x above runs along it
    std::size_t level = 0;
    double view_rad = 0;
};

/// Cosine of the largest angle between a ray of the picture and the camera's axis.
double cosine_at_corner(const Camera& camera) {
    const double x = std::max(std::abs(camera.centre_x), std::abs(camera.size.width - camera.centre_x));
    const double y = std::max(std::abs(camera.centre_y), std::abs(camera.size.height - camera.centre_y));
    return camera.focal_px / std::sqrt(camera.focal_px * camera.focal_px + x * x + y * y);
}

double pixels_per_metre_at(const Camera& camera, glm::dvec3 point, double corner) {
    // Across the ray, a metre at `distance` measures focal / depth to the side and distance / depth times
    // that away from the centre.
    const glm::dvec3 to_point = point - camera.position;
    const double distance = glm::length(to_point);
    const double cosine = distance > 0 ? std::max(glm::dot(camera.forward, to_point) / distance, corner) : 1;
    return camera.focal_px / (std::max(distance, 1.0) * cosine * cosine);
}

/// A wire in its vertical plane, ready to be clothed.
class WireBuilder {
  public:
    WireBuilder(WireMeshes& meshes, std::span<const glm::dvec3> axis, glm::dvec3 along, double diameter_m,
                std::uint16_t material, const Camera& camera)
        : meshes_(meshes),
          axis_(axis),
          side_(-along.y, along.x, 0),
          radius_(diameter_m / 2),
          material_(material),
          segments_(axis.size() - 1),
          mitre_(axis.size()) {
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            Segment& segment = segments_[i];
            segment.above = glm::normalize(glm::cross(axis[i + 1] - axis[i], side_));
            const double diameter_px = diameter_m * pixels_per_metre(camera, axis[i], axis[i + 1]);
            while (diameter_px < kWireLevels[segment.level].from_diameter_px) ++segment.level;
            segment.view_rad = view_angle_rad(camera, axis[i], axis[i + 1], along);
        }
        mitre_.front() = segments_.front().above;
        mitre_.back() = segments_.back().above;
        for (std::size_t i = 1; i < segments_.size(); ++i) {
            // Along the bisector, and so long that it measures 1 across either segment.
            const glm::dvec3 one = segments_[i - 1].above, next = segments_[i].above;
            mitre_[i] = (one + next) / (1 + glm::dot(one, next));
        }
    }

    void build() {
        for (std::size_t begin = 0; begin < segments_.size();) {
            const std::size_t level = segments_[begin].level;
            const std::size_t before = meshes_.prisms.face_count() + meshes_.ribbons.face_count();
            begin = kWireLevels[level].sides > 0 ? add_prism(begin) : add_ribbon(begin);
            meshes_.facets[level] += meshes_.prisms.face_count() + meshes_.ribbons.face_count() - before;
        }
    }

  private:
    /// Adds the vertex at joint `i` that lies `out` radii from the axis in the direction `angle_rad` around
    /// it.
    std::uint32_t add_vertex(Mesh& mesh, std::size_t i, double angle_rad, glm::dvec3 normal) const {
        mesh.normals.emplace_back(glm::normalize(normal));
        return mesh.add_position(axis_[i] + radius_ * around(i, angle_rad));
    }
    glm::dvec3 around(std::size_t i, double angle_rad) const {
        return side_ * std::cos(angle_rad) + mitre_[i] * std::sin(angle_rad);
    }

    /// From segment `begin` as far as the level stays and the view turns by no more than kPrismTurn; returns
    /// the segment after. Two opposite corners lie on the outline that the viewer sees: it is a whole
    /// diameter wide.
    std::size_t add_prism(std::size_t begin) {
        const Segment& first = segments_[begin];
        const int sides = kWireLevels[first.level].sides;
        std::size_t end = begin + 1;
        while (end < segments_.size() && segments_[end].level == first.level &&
               std::abs(std::remainder(segments_[end].view_rad - first.view_rad, 2 * kPi / sides)) <=
                   kPrismTurn)
            ++end;
        const auto n = static_cast<std::uint32_t>(sides);
        Mesh& mesh = meshes_.prisms;
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::size_t i = begin; i <= end; ++i)
            for (std::uint32_t k = 0; k < n; ++k) {
                const double angle = first.view_rad + kPi / 2 + 2 * kPi * k / sides;
                add_vertex(mesh, i, angle, around(i, angle));
            }
        const auto rings = static_cast<std::uint32_t>(end - begin);
        for (std::uint32_t ring = 0; ring < rings; ++ring)
            for (std::uint32_t k = 0; k < n; ++k) {
                const std::uint32_t here = base + ring * n + k, beside = base + ring * n + (k + 1) % n;
                mesh.add_face(std::array{here, beside, beside + n, here + n}, material_);
            }
        std::vector<std::uint32_t> cap(n);
        for (std::uint32_t k = 0; k < n; ++k) cap[k] = base + n - 1 - k;
        mesh.add_face(cap, material_);
        for (std::uint32_t k = 0; k < n; ++k) cap[k] = base + rings * n + k;
        mesh.add_face(cap, material_);
        return end;
    }

    /// The same for ribbons, which go on while they are ribbons: a segment whose view has turned by more than
    /// kRibbonTurn since the strip was last turned takes the turn.
    std::size_t add_ribbon(std::size_t begin) {
        const std::size_t level = segments_[begin].level;
        Mesh& mesh = meshes_.ribbons;
        double facing = segments_[begin].view_rad;
        auto [left, right] = add_rung(begin, facing, facing);
        std::size_t i = begin;
        for (; i < segments_.size() && segments_[i].level == level; ++i) {
            const double turn = std::remainder(segments_[i].view_rad - facing, kPi);
            const bool turns = std::abs(turn) > kRibbonTurn;
            if (turns) facing += turn;
            const auto [next_left, next_right] = add_rung(i + 1, facing, segments_[i].view_rad);
            if (turns) {
                mesh.add_face(std::array{right, left, next_left}, material_);
                mesh.add_face(std::array{right, next_left, next_right}, material_);
            } else {
                mesh.add_face(std::array{right, left, next_left, next_right}, material_);
            }
            left = next_left;
            right = next_right;
        }
        return i;
    }

    /// Both edges of the strip at joint `i`. Normals are those of a round wire, halfway between its middle
    /// and its outline where the strip ends: 60 degrees from the view, so that interpolation meets the
    /// middle's.
    std::array<std::uint32_t, 2> add_rung(std::size_t i, double facing_rad, double view_rad) {
        const double across = facing_rad + kPi / 2;
        const double towards = std::cos(view_rad - facing_rad) >= 0 ? facing_rad : facing_rad + kPi;
        const glm::dvec3 front = 0.5 * around(i, towards), out = std::sqrt(0.75) * around(i, across);
        return {add_vertex(meshes_.ribbons, i, across, front + out),
                add_vertex(meshes_.ribbons, i, across + kPi, front - out)};
    }

    WireMeshes& meshes_;
    std::span<const glm::dvec3> axis_;
    glm::dvec3 side_;
    double radius_;
    std::uint16_t material_;
    std::vector<Segment> segments_;
    std::vector<glm::dvec3> mitre_;  ///< for each joint: `above`, stretched into the mitre's plane
};

}  // namespace

double pixels_per_metre(const Camera& camera, glm::dvec3 p, glm::dvec3 q) {
    if (camera.kind == Camera::Kind::Orthographic) return camera.focal_px;
    const double corner = cosine_at_corner(camera);
    const glm::dvec3 run = q - p;
    const double length2 = glm::dot(run, run);
    const double share = length2 > 0 ? std::clamp(glm::dot(camera.position - p, run) / length2, 0.0, 1.0) : 0;
    return std::max({pixels_per_metre_at(camera, p, corner), pixels_per_metre_at(camera, q, corner),
                     pixels_per_metre_at(camera, p + run * share, corner)});
}

double view_angle_rad(const Camera& camera, glm::dvec3 p, glm::dvec3 q, glm::dvec3 along) {
    const glm::dvec3 to_eye =
        camera.kind == Camera::Kind::Perspective ? camera.position - (p + q) / 2.0 : -camera.forward;
    const glm::dvec3 side(-along.y, along.x, 0);
    const glm::dvec3 above = glm::normalize(glm::cross(q - p, side));
    return std::atan2(glm::dot(to_eye, above), glm::dot(to_eye, side));
}

void add_wire(WireMeshes& meshes, std::span<const glm::dvec3> axis, glm::dvec3 along, double diameter_m,
              std::uint16_t material, const Camera& camera) {
    WireBuilder(meshes, axis, along, diameter_m, material, camera).build();
}

}  // namespace keikan
