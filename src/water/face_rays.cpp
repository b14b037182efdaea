// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/face_rays.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "keikan/support/check.hpp"

namespace keikan {

namespace {

struct Vertex {
    float x, y, z;
};

struct Triangle {
    std::uint32_t a, b, c;
};

Rgb mixed(Rgb from, Rgb to, float share) {
    return (1 - share) * from + share * to;
}

Rgb ramp_colour(const HeightSlopeRamp& ramp, float height_m) {
    const auto& stops = ramp.stops;
    if (height_m <= stops.front().height_m) return stops.front().colour;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const auto &low = stops[i - 1], &high = stops[i];
        if (height_m < high.height_m)
            return mixed(low.colour, high.colour, (height_m - low.height_m) / (high.height_m - low.height_m));
    }
    return stops.back().colour;
}

float steep_share(const HeightSlopeRamp& ramp, double normal_z) {
    const double slope_deg = std::acos(std::min(std::abs(normal_z), 1.0)) * 180 / std::numbers::pi;
    if (slope_deg <= static_cast<double>(ramp.steep_from_deg)) return 0;
    if (slope_deg >= static_cast<double>(ramp.steep_full_deg)) return 1;
    return (static_cast<float>(slope_deg) - ramp.steep_from_deg) /
           (ramp.steep_full_deg - ramp.steep_from_deg);
}

}  // namespace

struct FaceRays::Hierarchy {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    glm::dvec3 origin{0, 0, 0};                       ///< of the floats
    std::vector<const Mesh*> mesh;                    ///< one for each Embree geometry
    std::vector<std::vector<std::uint32_t>> face_of;  ///< triangle to face of its mesh
    std::vector<std::vector<Triangle>> triangles;

    ~Hierarchy() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void add(const Mesh& added) {
        std::vector<std::uint32_t> faces;
        std::vector<Triangle> corners_of;
        for (std::size_t f = 0; f < added.face_count(); ++f) {
            const auto corners = added.face(f);
            for (std::size_t i = 2; i < corners.size(); ++i) {
                corners_of.push_back({corners[0], corners[i - 1], corners[i]});
                faces.push_back(static_cast<std::uint32_t>(f));
            }
        }
        if (corners_of.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex = static_cast<Vertex*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex), added.positions.size()));
        auto* triangle = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), corners_of.size()));
        KEIKAN_CHECK(vertex != nullptr && triangle != nullptr, "Embree has no memory for the faces");
        for (const glm::dvec3& p : added.positions) {
            const glm::dvec3 q = p - origin;
            *vertex++ = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
        }
        std::copy(corners_of.begin(), corners_of.end(), triangle);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(mesh.size()));
        rtcReleaseGeometry(geometry);
        mesh.push_back(&added);
        face_of.push_back(std::move(faces));
        triangles.push_back(std::move(corners_of));
    }
};

FaceRays::FaceRays(const Scene& scene, const Geometry& geometry)
    : scene_(scene), hierarchy_(std::make_unique<Hierarchy>()) {
    Hierarchy& work = *hierarchy_;
    // One thread builds, so that the hierarchy, and which of two faces that meet in a ray is hit, is always
    // the same.
    work.device = rtcNewDevice("threads=1");
    KEIKAN_CHECK(work.device != nullptr, "Embree gives no device");
    work.scene = rtcNewScene(work.device);
    rtcSetSceneFlags(work.scene, RTC_SCENE_FLAG_ROBUST);
    work.origin = scene.camera.position;
    for (const Object& object : geometry.objects)
        if (object.kind != ObjectKind::Water) work.add(object.mesh);
    rtcCommitScene(work.scene);
    KEIKAN_CHECK(rtcGetDeviceError(work.device) == RTC_ERROR_NONE, "Embree could not build its hierarchy");
}

FaceRays::~FaceRays() = default;

std::optional<FaceHit> FaceRays::first_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                           double farthest_m) const {
    const Hierarchy& work = *hierarchy_;
    const glm::dvec3 from = origin - work.origin;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(from.x);
    ray.ray.org_y = static_cast<float>(from.y);
    ray.ray.org_z = static_cast<float>(from.z);
    ray.ray.dir_x = static_cast<float>(direction.x);
    ray.ray.dir_y = static_cast<float>(direction.y);
    ray.ray.dir_z = static_cast<float>(direction.z);
    ray.ray.tnear = static_cast<float>(kRayStart_m);
    ray.ray.tfar = static_cast<float>(farthest_m);
    ray.ray.mask = 0xFFFFFFFFu;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(work.scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Mesh& mesh = *work.mesh[ray.hit.geomID];
    const Triangle corner = work.triangles[ray.hit.geomID][ray.hit.primID];
    FaceHit hit;
    hit.distance_m = static_cast<double>(ray.ray.tfar);
    hit.material = mesh.face_material[work.face_of[ray.hit.geomID][ray.hit.primID]];
    const glm::dvec3 across = glm::cross(mesh.positions[corner.b] - mesh.positions[corner.a],
                                         mesh.positions[corner.c] - mesh.positions[corner.a]);
    const double area = glm::length(across);
    if (area > 0) hit.flat_normal = across / area;
    hit.normal = hit.flat_normal;
    if (!mesh.normals.empty()) {
        const auto normal = [&](std::uint32_t i) { return glm::dvec3(mesh.normals[i]); };
        const double u = static_cast<double>(ray.hit.u), v = static_cast<double>(ray.hit.v);
        const glm::dvec3 smooth =
            (1 - u - v) * normal(corner.a) + u * normal(corner.b) + v * normal(corner.c);
        const double length = glm::length(smooth);
        if (length > 0) hit.normal = smooth / length;
    }
    return hit;
}

bool FaceRays::any_hit(const glm::dvec3& origin, const glm::dvec3& direction, double farthest_m) const {
    const glm::dvec3 from = origin - hierarchy_->origin;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{};
    ray.org_x = static_cast<float>(from.x);
    ray.org_y = static_cast<float>(from.y);
    ray.org_z = static_cast<float>(from.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = static_cast<float>(kRayStart_m);
    ray.tfar = static_cast<float>(farthest_m);
    ray.mask = 0xFFFFFFFFu;
    rtcOccluded1(hierarchy_->scene, &context, &ray);
    return ray.tfar < 0;
}

Rgb FaceRays::albedo(const FaceHit& hit, const glm::dvec3& point) const {
    const Material& material = scene_.materials[hit.material];
    if (!material.ramp) return material.colour;
    return mixed(ramp_colour(*material.ramp, static_cast<float>(point.z)), material.ramp->steep,
                 steep_share(*material.ramp, hit.flat_normal.z));
}

Rgb FaceRays::colour(const FaceHit& hit, const glm::dvec3& point, const glm::dvec3& direction) const {
    const Light& light = scene_.light;
    const Material& material = scene_.materials[hit.material];
    const double side = glm::dot(hit.flat_normal, direction) <= 0 ? 1 : -1;
    const glm::dvec3 n = side * hit.normal;
    const Rgb own = albedo(hit, point);
    const Rgb ambient = light.ground_ambient + static_cast<float>(0.5 + 0.5 * n.z) *
                                                   (light.sky_ambient + -1.0f * light.ground_ambient);
    const double facing = glm::dot(n, light.to_sun);
    if (facing <= 0) return ambient * own;
    Rgb colour = own * (ambient + (material.diffuse * static_cast<float>(facing)) * light.sun);
    if (material.specular > 0) {
        const double along = -glm::dot(2 * facing * n - light.to_sun, direction);
        if (along > 0)
            colour = colour +
                     (material.specular * std::pow(static_cast<float>(along), material.exponent)) * light.sun;
    }
    return colour;
}

Rgb sky_colour(const Background& background, const glm::dvec3& direction) {
    return mixed(background.horizon, background.zenith,
                 static_cast<float>(std::clamp(direction.z, 0.0, 1.0)));
}

Rgb through_haze(const Haze& haze, Rgb colour, double distance_m) {
    if (!(haze.range_m > 0)) return colour;
    return mixed(haze.colour, colour, static_cast<float>(std::exp(-distance_m / haze.range_m)));
}

}  // namespace keikan
