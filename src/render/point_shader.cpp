// SPDX-License-Identifier: Apache-2.0
#include "point_shader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace keikan {

namespace {

glm::vec3 vector_of(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// `n` at unit length; vertex normals that cancel out leave the plane's own.
glm::vec3 unit_or_flat(const glm::vec3& n, const SeenFace& face) {
    const float length = std::sqrt(glm::dot(n, n));
    return length > 0 ? (1 / length) * n : vector_of(face.flat_normal);
}

}  // namespace

PointShader::PointShader(const Scene& scene)
    : scene_(scene),
      sky_(scene.background, scene.light),
      camera_(scene.camera),
      perspective_(camera_.kind == Camera::Kind::Perspective),
      forward_(camera_.forward),
      step_right_(camera_.right / camera_.focal_px),
      step_down_(camera_.down / camera_.focal_px),
      to_sun_(scene.light.to_sun),
      sky_over_ground_(scene.light.sky_ambient + -1.0f * scene.light.ground_ambient),
      haze_per_m_(scene.haze.range_m > 0 ? 1 / scene.haze.range_m : 0) {}

double PointShader::depth(const SeenFace& face, double x, double y) const {
    const double w = face.plane.a * x + face.plane.b * y + face.plane.c;
    if (!perspective_) return std::min(-w, kFarthest_m);
    return w * kFarthest_m > 1 ? 1 / w : kFarthest_m;
}

double PointShader::height_m(double x, double y, double depth_m, const glm::vec3& towards) const {
    if (!perspective_) return camera_.world_point(x, y, camera_.nearness_at(depth_m)).z;
    return camera_.position.z + depth_m * static_cast<double>(towards.z);
}

Rgb PointShader::hazed(Rgb colour, double depth_m, float ray_length) const {
    if (!(haze_per_m_ > 0)) return colour;
    const float ranges = static_cast<float>(depth_m * haze_per_m_) * (perspective_ ? ray_length : 1);
    return mixed(scene_.haze.colour, colour, std::exp(-ranges));
}

Rgb PointShader::background_colour(double x, double y) const {
    const glm::dvec3 towards(ray(x, y));
    const double length = glm::length(towards);
    const double pixel_rad = perspective_ ? 1 / (camera_.focal_px * length * length) : 0;
    return sky_.colour_with_sun((1 / length) * towards, pixel_rad);
}

FaceShader::FaceShader(const PointShader& shader, const SeenFace& face)
    : all_(shader),
      face_(face),
      material_(shader.scene_.materials[face.material]),
      bends_(face.normal[1] != std::array<float, 3>{} || face.normal[2] != std::array<float, 3>{}),
      normal_(bends_ ? glm::vec3(0) : unit_or_flat(vector_of(face.normal[0]), face)) {}

glm::vec3 FaceShader::unit_normal(double x, double y) const {
    if (!bends_) return normal_;
    const auto dx = static_cast<float>(x - face_.normal_at.x), dy = static_cast<float>(y - face_.normal_at.y);
    return unit_or_flat(
        vector_of(face_.normal[0]) + dx * vector_of(face_.normal[1]) + dy * vector_of(face_.normal[2]),
        face_);
}

Rgb FaceShader::albedo(double x, double y, double depth_m, const glm::vec3& towards, float normal_z) const {
    if (!material_.ramp) return material_.colour;
    const HeightSlopeRamp& ramp = *material_.ramp;
    const float steep = ramp.steep_share(normal_z);
    if (steep >= 1) return ramp.steep;
    const Rgb by_height = ramp.colour_at(static_cast<float>(all_.height_m(x, y, depth_m, towards)));
    return steep > 0 ? mixed(by_height, ramp.steep, steep) : by_height;
}

Rgb FaceShader::colour(double x, double y, float sun_share) const {
    const Light& light = all_.scene_.light;
    const double depth_m = all_.depth(face_, x, y);
    const glm::vec3 n = unit_normal(x, y);
    const glm::vec3 towards = all_.ray(x, y);
    const float ray_length = std::sqrt(glm::dot(towards, towards));
    const Rgb own = albedo(x, y, depth_m, towards, n.z);

    const Rgb ambient = light.ground_ambient + (0.5f + 0.5f * n.z) * all_.sky_over_ground_;
    const float facing = glm::dot(n, all_.to_sun_);
    if (facing <= 0 || !(sun_share > 0)) return all_.hazed(ambient * own, depth_m, ray_length);
    const Rgb sun = sun_share * light.sun;
    Rgb colour = own * (ambient + (material_.diffuse * facing) * sun);
    if (material_.specular > 0) {
        const glm::vec3 mirrored = 2 * facing * n - all_.to_sun_;
        const float along = -glm::dot(mirrored, towards) / ray_length;
        if (along > 0) colour = colour + (material_.specular * std::pow(along, material_.exponent)) * sun;
    }
    return all_.hazed(colour, depth_m, ray_length);
}

}  // namespace keikan
