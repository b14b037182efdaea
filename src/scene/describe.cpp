// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "keikan/scene/scene.hpp"

namespace keikan {
namespace {

constexpr std::array<const char*, 7> kKindNames{"terrain",  "tower", "insulator", "conductor",
                                                "building", "model", "water"};

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// Compass bearing of a direction, [0, 360).
double bearing_deg(const glm::dvec3& direction) {
    const double bearing = degrees(std::atan2(direction.x, direction.y));
    return bearing < 0 ? bearing + 360 : bearing;
}

double elevation_deg(const glm::dvec3& direction) {
    return degrees(std::atan2(direction.z, std::hypot(direction.x, direction.y)));
}

std::string camera_text(const Camera& camera) {
    const bool perspective = camera.kind == Camera::Kind::Perspective;
    const double across = perspective ? degrees(2 * std::atan(camera.size.width / (2 * camera.focal_px)))
                                      : camera.size.width / camera.focal_px;
    return fmt::format(
        "camera     {} at ({:.2f}, {:.2f}, {:.2f}) m, bearing {:.2f}, elevation {:.2f} degrees, {:.2f} {} "
        "wide, "
        "{} x {} pixels\n",
        perspective ? "perspective" : "orthographic", camera.position.x, camera.position.y, camera.position.z,
        bearing_deg(camera.forward), elevation_deg(camera.forward), across, perspective ? "degrees" : "m",
        camera.size.width, camera.size.height);
}

std::string kinds_text(const Geometry& geometry) {
    std::array<std::size_t, kKindNames.size()> objects{}, faces{};
    for (const Object& object : geometry.objects) {
        const auto kind = static_cast<std::size_t>(object.kind);
        ++objects[kind];
        faces[kind] += object.mesh.face_count();
    }
    std::string text;
    for (std::size_t kind = 0; kind < kKindNames.size(); ++kind) {
        if (objects[kind] > 0) {
            text += fmt::format("  {:<10} {:>8} objects {:>10} faces\n", kKindNames[kind], objects[kind],
                                faces[kind]);
        }
    }
    return text + fmt::format("  {:<10} {:>8} objects {:>10} faces\n", "all", geometry.objects.size(),
                              geometry.first_face.back());
}

}  // namespace

std::string describe(const Scene& scene, const Geometry& geometry) {
    std::string text = fmt::format("scene      {}\n", scene.file.string()) + camera_text(scene.camera);
    text += fmt::format("sun        bearing {:.2f}, elevation {:.2f} degrees\n",
                        bearing_deg(scene.light.to_sun), elevation_deg(scene.light.to_sun));
    text += fmt::format("sky        {}, {}, {}\n",
                        scene.background.model == SkyModel::CieClear ? "CIE clear" : "gradient",
                        scene.background.sun_disc ? "sun's disc seen" : "no sun's disc",
                        scene.light.shadows != Shadows::Off ? "shadows of the sun's disc" : "no shadows");
    text += fmt::format("haze       {}\n", scene.haze.range_m > 0
                                               ? fmt::format("range {:g} m", scene.haze.range_m)
                                               : std::string("none"));
    text += fmt::format("materials  {}\n", scene.materials.size());
    text += fmt::format("geometry   {:016x}\n", scene.geometry_hash) + kinds_text(geometry);
    for (const std::string& note : geometry.notes) text += fmt::format("  {}\n", note);
    return text;
}

}  // namespace keikan
