// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "degree.hpp"
#include "keikan/scene/sun_position.hpp"
#include "scene_blocks.hpp"

namespace keikan {
namespace {

constexpr double kFullFrameWidthMm = 36;
constexpr int kLargestSide = 65536;

/// A point [x, y, z], or [x, y] together with its height above the ground.
glm::dvec3 read_point(JsonObject& object, const char* key, const char* height_key,
                      const TerrainHeight& ground) {
    const JsonNode point = object.required(key);
    const auto height = object.optional(height_key);
    if (!height) {
        if (point.value().is_array() && point.value().size() == 2) {
            point.fail(fmt::format("needs a third number, or the key \"{}\" beside it", height_key));
        }
        return point.triple();
    }
    if (point.value().is_array() && point.value().size() == 3) {
        point.fail(fmt::format("has a height and \"{}\" beside it; one is enough", height_key));
    }
    const glm::dvec2 place = point.pair();
    const auto ground_height = ground(place.x, place.y);
    if (!ground_height)
        point.fail(fmt::format("lies beside the terrain, which \"{}\" counts from", height_key));
    return {place, *ground_height + height->number()};
}

glm::dvec3 direction_from_angles(double yaw_deg, double pitch_deg) {
    return direction_of({yaw_deg * kDegree, pitch_deg * kDegree});  // yaw is a compass bearing
}

void aim(JsonObject& object, Camera& camera, const TerrainHeight& ground) {
    const double roll = object.number_or("roll_deg", 0, between(-360, 360)) * kDegree;
    if (object.exactly_one_of({"target", "yaw_deg"}) == "target") {
        const glm::dvec3 target = read_point(object, "target", "target_height_above_ground_m", ground);
        if (target == camera.position) object.required("target").fail("is the camera's own position");
        camera.look_along(target - camera.position, roll);
    } else {
        const double yaw = object.required("yaw_deg").number(between(-360, 360));
        const double pitch = object.number_or("pitch_deg", 0, between(-90, 90));
        camera.look_along(direction_from_angles(yaw, pitch), roll);
    }
}

double perspective_focal_px(JsonObject& object, ImageSize size) {
    const std::string key =
        object.exactly_one_of({"focal_length_35mm", "horizontal_fov_deg", "vertical_fov_deg"});
    const JsonNode node = object.required(key);
    if (key == "focal_length_35mm") return node.number(positive_up_to(1e5)) / kFullFrameWidthMm * size.width;
    const double angle =
        node.number({.low = 0, .high = 180, .above_low = true, .below_high = true}) * kDegree;
    const int side = key == "horizontal_fov_deg" ? size.width : size.height;
    return side / (2 * std::tan(angle / 2));
}

}  // namespace

ImageSize read_image_size(const JsonNode& node) {
    JsonObject object(node);
    const ImageSize size{object.required("width").integer(1, kLargestSide),
                         object.required("height").integer(1, kLargestSide)};
    object.no_other_keys();
    return size;
}

Camera read_camera(const JsonNode& node, ImageSize size, const TerrainHeight& ground) {
    JsonObject object(node);
    Camera camera;
    camera.size = size;
    const std::string kind = object.text_or("type", "perspective");
    if (kind == "perspective") {
        camera.focal_px = perspective_focal_px(object, size);
    } else if (kind == "orthographic") {
        camera.kind = Camera::Kind::Orthographic;
        camera.focal_px = size.width / object.required("width_m").number(positive());
    } else {
        object.required("type").fail("must be \"perspective\" or \"orthographic\"");
    }
    camera.position = read_point(object, "position", "height_above_ground_m", ground);
    aim(object, camera, ground);
    camera.near_m = object.number_or("near_m", camera.near_m, positive());
    glm::dvec2 shift(0, 0);
    if (const auto given = object.optional("shift")) {
        shift = given->pair();
        if (std::abs(shift.x) > 10 || std::abs(shift.y) > 10) given->fail("must be within 10 pictures");
    }
    camera.centre_x = size.width * (0.5 - shift.x);
    camera.centre_y = size.height * (0.5 + shift.y);
    object.no_other_keys();
    return camera;
}

}  // namespace keikan
