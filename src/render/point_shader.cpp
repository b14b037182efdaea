// SPDX-License-Identifier: Apache-2.0
#include "point_shader.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace keikan {

namespace {

Rgb mix(Rgb from, Rgb to, float share) { return (1 - share) * from + share * to; }

Rgb ramp_colour(const HeightSlopeRamp& ramp, float height_m) {
    const auto& stops = ramp.stops;
    if (height_m <= stops.front().height_m) return stops.front().colour;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const auto &low = stops[i - 1], &high = stops[i];
        if (height_m < high.height_m)
            return mix(low.colour, high.colour, (height_m - low.height_m) / (high.height_m - low.height_m));
    }
    return stops.back().colour;
}

/// How much of `steep` shows on a plane whose unit normal has this z, of either side.
float steep_share(const HeightSlopeRamp& ramp, float normal_z) {
    constexpr float kDegree = std::numbers::pi_v<float> / 180;
    const float slope_deg = std::acos(std::min(std::abs(normal_z), 1.0f)) / kDegree;
    if (slope_deg <= ramp.steep_from_deg) return 0;
    if (slope_deg >= ramp.steep_full_deg) return 1;
    return (slope_deg - ramp.steep_from_deg) / (ramp.steep_full_deg - ramp.steep_from_deg);
}

glm::vec3 unit_normal(const SeenFace& face, double x, double y) {
    const auto dx = static_cast<float>(x - face.normal_at.x), dy = static_cast<float>(y - face.normal_at.y);
    glm::vec3 n;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        n[k] = face.normal[0][i] + face.normal[1][i] * dx + face.normal[2][i] * dy;
    }
    const float length = std::sqrt(glm::dot(n, n));
    if (length > 0) return n / length;
    // Vertex normals that cancel out leave the plane's own.
    return {face.flat_normal[0], face.flat_normal[1], face.flat_normal[2]};
}

}  // namespace

PointShader::PointShader(const Scene& scene)
    : scene_(scene),
      camera_(scene.camera),
      perspective_(camera_.kind == Camera::Kind::Perspective),
      step_right_(camera_.right / camera_.focal_px),
      step_down_(camera_.down / camera_.focal_px),
      to_sun_(scene.light.to_sun),
      haze_per_m_(scene.haze.range_m > 0 ? 1 / scene.haze.range_m : 0) {}

double PointShader::depth(const SeenFace& face, double x, double y) const {
    const double w = face.plane.a * x + face.plane.b * y + face.plane.c;
    if (!perspective_) return std::min(-w, kFarthest_m);
    return w * kFarthest_m > 1 ? 1 / w : kFarthest_m;
}

Rgb PointShader::albedo(const Material& material, const SeenFace& face, double x, double y, double depth_m) const {
    if (!material.ramp) return material.colour;
    const HeightSlopeRamp& ramp = *material.ramp;
    const float steep = steep_share(ramp, face.flat_normal[2]);
    if (steep >= 1) return ramp.steep;
    // The z of Camera::world_point, which is all that the ramp looks at.
    const double height_m =
        perspective_ ? camera_.position.z + depth_m * ray(x, y).z
                     : camera_.world_point(x, y, camera_.nearness_at(depth_m)).z;
    return mix(ramp_colour(ramp, static_cast<float>(height_m)), ramp.steep, steep);
}

Rgb PointShader::face_colour(const SeenFace& face, double x, double y) const {
    const Material& material = scene_.materials[face.material];
    const Light& light = scene_.light;
    const double depth_m = depth(face, x, y);
    const glm::vec3 towards = ray(x, y);
    const float ray_length = std::sqrt(glm::dot(towards, towards));
    const glm::vec3 n = unit_normal(face, x, y);
    const Rgb own = albedo(material, face, x, y, depth_m);

    const Rgb ambient = mix(light.ground_ambient, light.sky_ambient, (1 + n.z) / 2);
    Rgb colour = ambient * own;
    const float facing = glm::dot(n, to_sun_);
    if (facing > 0) {
        colour = colour + (material.diffuse * facing) * (light.sun * own);
        if (material.specular > 0) {
            const glm::vec3 mirrored = 2 * facing * n - to_sun_;
            const float along = -glm::dot(mirrored, towards) / ray_length;
            if (along > 0) colour = colour + (material.specular * std::pow(along, material.exponent)) * light.sun;
        }
    }
    if (haze_per_m_ > 0) {
        const auto distances = static_cast<float>(depth_m * haze_per_m_) * (perspective_ ? ray_length : 1);
        colour = mix(scene_.haze.colour, colour, std::exp(-distances));
    }
    return colour;
}

Rgb PointShader::background_colour(double x, double y) const {
    const glm::vec3 towards = ray(x, y);
    const float rising = std::clamp(towards.z / std::sqrt(glm::dot(towards, towards)), 0.0f, 1.0f);
    return mix(scene_.background.horizon, scene_.background.zenith, rising);
}

}  // namespace keikan
