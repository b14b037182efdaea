// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/water_footprint.hpp"

#include <algorithm>
#include <limits>

namespace keikan {

namespace {

/// How far below the plane the ray is at `farthest`: affine over the pixel, so that its zero is a straight
/// line.
double below(const ViewRay& ray, double farthest) {
    return -(ray.origin.z + farthest * ray.direction.z);
}

glm::dvec2 on_plane(const ViewRay& ray) {
    const double t = ray.origin.z / -ray.direction.z;
    return {ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y};
}

}  // namespace

glm::dvec2 WaterFootprint::centre() const {
    glm::dvec2 sum(0, 0);
    for (const glm::dvec2 corner : outline()) sum += corner;
    return count > 0 ? sum / static_cast<double>(count) : sum;
}

double WaterFootprint::extent_m(glm::dvec2 direction) const {
    if (count == 0) return 0;
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const glm::dvec2 corner : outline()) {
        const double along = corner.x * direction.x + corner.y * direction.y;
        least = std::min(least, along);
        greatest = std::max(greatest, along);
    }
    return greatest - least;
}

WaterFootprint water_footprint(const std::array<ViewRay, 4>& corners, double farthest) {
    WaterFootprint footprint;
    const auto add = [&](const ViewRay& ray) {
        footprint.corners[static_cast<std::size_t>(footprint.count++)] = on_plane(ray);
    };
    for (std::size_t i = 0; i < 4; ++i) {
        const ViewRay &p = corners[i], &q = corners[(i + 1) % 4];
        const double at_p = below(p, farthest), at_q = below(q, farthest);
        if (at_p >= 0) add(p);
        footprint.reaches_horizon |= at_p < 0;
        if ((at_p >= 0) == (at_q >= 0)) continue;
        const double s = at_p / (at_p - at_q);
        ViewRay cut{p.origin + s * (q.origin - p.origin), p.direction + s * (q.direction - p.direction)};
        // Rounding must not turn the ray upwards: on the cut it arrives at `farthest`.
        cut.direction.z = std::min(cut.direction.z, -cut.origin.z / farthest);
        add(cut);
    }
    return footprint;
}

}  // namespace keikan
