// SPDX-License-Identifier: Apache-2.0
#include "prism_parts.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace keikan {

namespace {

struct SectionPoint {
    double u, v;
};

/// The side faces and nothing else: ring `lower` is below ring `upper`, both counter-clockwise seen from
/// above.
void add_sides(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t count,
               std::uint16_t material) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = (k + 1) % count;
        mesh.add_face(std::array{lower + k, lower + next, upper + next, upper + k}, material);
    }
}

}  // namespace

void add_member(Mesh& mesh, SteelProfile profile, glm::dvec3 from, glm::dvec3 to, glm::dvec3 outward,
                double width_m, std::uint16_t material, bool mirrored) {
    const glm::dvec3 axis = glm::normalize(to - from);
    const glm::dvec3 v = glm::normalize(outward - axis * glm::dot(outward, axis));
    const glm::dvec3 u = glm::cross(v, axis);
    const double r = width_m / 2, t = width_m * kFlangeShare;

    // Counter-clockwise for one who looks against the axis. The heel of the angle is corner 0, its inner
    // corner 3.
    static constexpr int kMost = 6;
    std::array<SectionPoint, kMost> section{};
    std::uint32_t count = 4;
    if (profile == SteelProfile::Square) {
        section = {{{-r, -r}, {r, -r}, {r, r}, {-r, r}}};
    } else {
        count = 6;
        if (mirrored)
            section = {{{r, r}, {-r, r}, {-r, r - t}, {r - t, r - t}, {r - t, -r}, {r, -r}}};
        else
            section = {{{-r, r}, {-r, -r}, {t - r, -r}, {t - r, r - t}, {r, r - t}, {r, r}}};
    }

    const auto lower = static_cast<std::uint32_t>(mesh.positions.size());
    const std::uint32_t upper = lower + count;
    for (const glm::dvec3& end : {from, to})
        for (std::uint32_t k = 0; k < count; ++k)
            mesh.add_position(end + u * section[k].u + v * section[k].v);
    add_sides(mesh, lower, upper, count, material);
    // An angle's end is cut from heel to inner corner, which leaves two convex halves.
    for (std::uint32_t half = 0; half + 3 < count; half += 2) {
        const std::uint32_t a = half == 0 ? 1 : 3;
        mesh.add_face(std::array{upper, upper + a, upper + a + 1, upper + a + 2}, material);
        mesh.add_face(std::array{lower, lower + a + 2, lower + a + 1, lower + a}, material);
    }
}

void add_lathe(Mesh& mesh, glm::dvec3 from, glm::dvec3 axis, std::span<const LatheRing> rings, int sides,
               std::uint16_t material) {
    const glm::dvec3 aside = std::abs(axis.y) < 0.7 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(aside, axis));
    const glm::dvec3 v = glm::cross(axis, u);
    const auto count = static_cast<std::uint32_t>(sides);
    std::vector<glm::dvec3> spoke(count);
    for (std::uint32_t k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / sides;
        spoke[k] = u * std::cos(angle) + v * std::sin(angle);
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const LatheRing& ring : rings)
        for (const glm::dvec3& direction : spoke)
            mesh.add_position(from + axis * ring.along_m + direction * ring.radius_m);
    std::uint32_t lower = first;
    for (std::size_t i = 1; i < rings.size(); ++i, lower += count)
        add_sides(mesh, lower, lower + count, count, material);
    std::vector<std::uint32_t> cap(count);
    for (std::uint32_t k = 0; k < count; ++k) cap[k] = lower + k;
    mesh.add_face(cap, material);
    for (std::uint32_t k = 0; k < count; ++k) cap[k] = first + count - 1 - k;
    mesh.add_face(cap, material);
}

double radius_of_equal_width(int sides) {
    return std::numbers::pi / (sides * std::sin(std::numbers::pi / sides));
}

}  // namespace keikan
