// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/face_rays.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "keikan/scene/sky.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan {

namespace {

struct Vertex {
    float x, y, z;
};

struct Triangle {
    std::uint32_t a, b, c;
};

/// Rays that Embree follows at once.
constexpr std::size_t kPacket = 8;

/// What is farther away hides no light.
constexpr double kFarthestLight_m = 2e5;

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

    template <typename Rays>  // RTCRay8 or RTCRay
    void set(Rays& rays, std::size_t i, const FaceRay& ray) const {
        const glm::dvec3 from = ray.origin - origin;
        rays.org_x[i] = static_cast<float>(from.x);
        rays.org_y[i] = static_cast<float>(from.y);
        rays.org_z[i] = static_cast<float>(from.z);
        rays.dir_x[i] = static_cast<float>(ray.direction.x);
        rays.dir_y[i] = static_cast<float>(ray.direction.y);
        rays.dir_z[i] = static_cast<float>(ray.direction.z);
        rays.tnear[i] = static_cast<float>(kRayStart_m);
        rays.tfar[i] = static_cast<float>(ray.farthest_m);
        rays.mask[i] = 0xFFFFFFFFu;
    }

    FaceHit hit_of(unsigned geometry, unsigned primitive, float distance, float at_u, float at_v) const {
        const Mesh& met = *mesh[geometry];
        const Triangle corner = triangles[geometry][primitive];
        FaceHit hit;
        hit.distance_m = static_cast<double>(distance);
        hit.material = met.face_material[face_of[geometry][primitive]];
        const glm::dvec3 across = glm::cross(met.positions[corner.b] - met.positions[corner.a],
                                             met.positions[corner.c] - met.positions[corner.a]);
        const double area = glm::length(across);
        if (area > 0) hit.flat_normal = across / area;
        hit.normal = hit.flat_normal;
        if (met.normals.empty()) return hit;
        const auto normal = [&](std::uint32_t i) { return glm::dvec3(met.normals[i]); };
        const double u = static_cast<double>(at_u), v = static_cast<double>(at_v);
        const glm::dvec3 smooth =
            (1 - u - v) * normal(corner.a) + u * normal(corner.b) + v * normal(corner.c);
        const double length = glm::length(smooth);
        if (length > 0) hit.normal = smooth / length;
        return hit;
    }
};

FaceRays::FaceRays(const Scene& scene, const Geometry& geometry)
    : scene_(scene), hierarchy_(std::make_unique<Hierarchy>()) {
    Hierarchy& work = *hierarchy_;
    // A device that is told its number of threads would hold the whole program to it.
    work.device = rtcNewDevice(nullptr);
    KEIKAN_CHECK(work.device != nullptr, "Embree gives no device");
    work.scene = rtcNewScene(work.device);
    rtcSetSceneFlags(work.scene, RTC_SCENE_FLAG_ROBUST);
    work.origin = scene.camera.position;
    for (const Object& object : geometry.objects)
        if (object.kind != ObjectKind::Water) work.add(object.mesh);
    // One thread builds, so that the hierarchy, and which of two faces that meet in a ray is hit, is always
    // the same.
    on_one_thread([&] { rtcCommitScene(work.scene); });
    KEIKAN_CHECK(rtcGetDeviceError(work.device) == RTC_ERROR_NONE, "Embree could not build its hierarchy");
}

FaceRays::~FaceRays() = default;

void FaceRays::first_hits(std::span<const FaceRay> rays, std::span<std::optional<FaceHit>> hits) const {
    KEIKAN_CHECK(rays.size() == hits.size(), rays.size() << " rays, " << hits.size() << " hits");
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
        const std::size_t count = std::min(kPacket, rays.size() - begin);
        RTCRayHit8 packet{};
        alignas(32) int valid[kPacket];
        for (std::size_t i = 0; i < kPacket; ++i) {
            valid[i] = i < count ? -1 : 0;
            packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            if (i < count) hierarchy_->set(packet.ray, i, rays[begin + i]);
        }
        rtcIntersect8(valid, hierarchy_->scene, &context, &packet);
        for (std::size_t i = 0; i < count; ++i) {
            hits[begin + i].reset();
            if (packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID)
                hits[begin + i] = hierarchy_->hit_of(packet.hit.geomID[i], packet.hit.primID[i],
                                                     packet.ray.tfar[i], packet.hit.u[i], packet.hit.v[i]);
        }
    }
}

std::optional<FaceHit> FaceRays::first_hit(const FaceRay& ray) const {
    std::optional<FaceHit> hit;
    first_hits(std::span(&ray, 1), std::span(&hit, 1));
    return hit;
}

void FaceRays::any_hits(std::span<const FaceRay> rays, std::span<std::uint8_t> met) const {
    KEIKAN_CHECK(rays.size() == met.size(), rays.size() << " rays, " << met.size() << " answers");
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
        const std::size_t count = std::min(kPacket, rays.size() - begin);
        RTCRay8 packet{};
        alignas(32) int valid[kPacket];
        for (std::size_t i = 0; i < kPacket; ++i) {
            valid[i] = i < count ? -1 : 0;
            if (i < count) hierarchy_->set(packet, i, rays[begin + i]);
        }
        rtcOccluded8(valid, hierarchy_->scene, &context, &packet);
        for (std::size_t i = 0; i < count; ++i) met[begin + i] = packet.tfar[i] < 0 ? 1 : 0;
    }
}

bool FaceRays::any_hit(const FaceRay& ray) const {
    std::uint8_t met = 0;
    any_hits(std::span(&ray, 1), std::span(&met, 1));
    return met != 0;
}

FaceRay FaceRays::towards_light(const glm::dvec3& point, const glm::dvec3& flat_normal,
                                const glm::dvec3& to_light) const {
    // Vertices are rounded by 2^-24 of their distance from the camera, along each axis, and so is the ray's
    // origin.
    const double lift = kRayStart_m + 0x1p-22 * glm::length(point - hierarchy_->origin);
    const double side = glm::dot(flat_normal, to_light) < 0 ? -1 : 1;
    return {point + side * lift * flat_normal, to_light, kFarthestLight_m};
}

Rgb FaceRays::albedo(const FaceHit& hit, const glm::dvec3& point) const {
    const Material& material = scene_.materials[hit.material];
    if (!material.ramp) return material.colour;
    return mixed(material.ramp->colour_at(static_cast<float>(point.z)), material.ramp->steep,
                 material.ramp->steep_share(static_cast<float>(hit.normal.z)));
}

Rgb FaceRays::colour(const FaceHit& hit, const glm::dvec3& point, const glm::dvec3& direction,
                     float sun_share) const {
    const Light& light = scene_.light;
    const Material& material = scene_.materials[hit.material];
    const double side = glm::dot(hit.flat_normal, direction) <= 0 ? 1 : -1;
    const glm::dvec3 n = side * hit.normal;
    const Rgb own = albedo(hit, point);
    const Rgb ambient = light.ground_ambient + static_cast<float>(0.5 + 0.5 * n.z) *
                                                   (light.sky_ambient + -1.0f * light.ground_ambient);
    const double facing = glm::dot(n, light.to_sun);
    if (facing <= 0 || !(sun_share > 0)) return ambient * own;
    const Rgb sun = sun_share * light.sun;
    Rgb colour = own * (ambient + (material.diffuse * static_cast<float>(facing)) * sun);
    if (material.specular > 0) {
        const double along = -glm::dot(2 * facing * n - light.to_sun, direction);
        if (along > 0)
            colour =
                colour + (material.specular * std::pow(static_cast<float>(along), material.exponent)) * sun;
    }
    return colour;
}

SunDisc::SunDisc(const glm::dvec3& to_sun) : to_sun_(to_sun) {
    const glm::dvec3 aside = std::abs(to_sun.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const double rim = std::tan(kSunRadius_rad);
    right_ = glm::normalize(glm::cross(aside, to_sun));
    up_ = rim * glm::cross(to_sun, right_);
    right_ *= rim;
}

glm::dvec3 SunDisc::at(double u1, double u2) const {
    // Squares around the centre become circles: neighbours stay neighbours.
    const double a = 2 * u1 - 1, b = 2 * u2 - 1;
    const bool flat = std::abs(a) > std::abs(b);
    const double r = flat ? a : b, off = flat ? b : a;
    // An eighth of a turn at most, so that few terms of the series are enough: the rest is 4e-7.
    const double phi = r != 0 ? std::numbers::pi / 4 * (off / r) : 0, q = phi * phi;
    const double sine = phi * (1 - q / 6 * (1 - q / 20 * (1 - q / 42)));
    const double cosine = 1 - q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56)));
    const double x = r * (flat ? cosine : sine), y = r * (flat ? sine : cosine);
    return glm::normalize(to_sun_ + x * right_ + y * up_);
}

Rgb through_haze(const Haze& haze, Rgb colour, double distance_m) {
    if (!(haze.range_m > 0)) return colour;
    return mixed(haze.colour, colour, static_cast<float>(std::exp(-distance_m / haze.range_m)));
}

}  // namespace keikan
