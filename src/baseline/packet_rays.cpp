// SPDX-License-Identifier: Apache-2.0
#include "packet_rays.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <string>
#include <vector>

#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan::baseline {

namespace {

struct Vertex {
    float x, y, z;
};
struct Triangle {
    std::uint32_t a, b, c;
};

}  // namespace

struct PacketRays::Hierarchy {
    Camera camera;
    glm::vec3 right, down, forward;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> face_of;  ///< of each triangle

    ~Hierarchy() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
};

PacketRays::PacketRays(const FacesInView& view) : hierarchy_(std::make_unique<Hierarchy>()) {
    Hierarchy& h = *hierarchy_;
    h.camera = view.camera();
    const float scale = static_cast<float>(1 / h.camera.focal_px);
    h.right = scale * glm::vec3(h.camera.right);
    h.down = scale * glm::vec3(h.camera.down);
    h.forward = glm::vec3(h.camera.forward);
    h.device = rtcNewDevice(("threads=" + std::to_string(thread_count())).c_str());
    KEIKAN_CHECK(h.device != nullptr, "Embree gives no device");

    const ProjectedFaces& faces = view.faces();
    const Geometry& geometry = view.geometry();
    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const std::uint16_t object = view.object(f);
        const Mesh& mesh = geometry.objects[object].mesh;
        const auto first = static_cast<std::uint32_t>(vertices.size());
        const auto corners = mesh.face(faces.id[f] - geometry.first_face[object]);
        for (const std::uint32_t corner : corners) {
            const glm::vec3 q(mesh.positions[corner] - h.camera.position);
            vertices.push_back({q.x, q.y, q.z});
        }
        for (std::uint32_t i = 2; i < corners.size(); ++i) {
            triangles.push_back({first, first + i - 1, first + i});
            h.face_of.push_back(f);
        }
    }
    h.scene = rtcNewScene(h.device);
    rtcSetSceneFlags(h.scene, RTC_SCENE_FLAG_ROBUST);
    if (!triangles.empty()) {
        RTCGeometry mesh = rtcNewGeometry(h.device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* const vertex = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                     sizeof(Vertex), vertices.size());
        auto* const triangle = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                       sizeof(Triangle), triangles.size());
        std::copy(vertices.begin(), vertices.end(), static_cast<Vertex*>(vertex));
        std::copy(triangles.begin(), triangles.end(), static_cast<Triangle*>(triangle));
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(h.scene, mesh);
        rtcReleaseGeometry(mesh);
    }
    rtcCommitScene(h.scene);
    KEIKAN_CHECK(rtcGetDeviceError(h.device) == RTC_ERROR_NONE, "Embree could not build its hierarchy");
}

PacketRays::~PacketRays() = default;

void PacketRays::meet(PixelIndex first, const PacketPlaces& places, const std::array<bool, kPacket>& wanted,
                      PacketHits& hits) const {
    const Hierarchy& h = *hierarchy_;
    const bool perspective = h.camera.kind == Camera::Kind::Perspective;
    alignas(32) std::array<int, kPacket> valid;
    RTCRayHit8 rays;
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
        const PixelIndex pixel = pixel_of_lane(first, lane);
        const auto u = static_cast<float>(pixel.x + places[lane].x - h.camera.centre_x);
        const auto v = static_cast<float>(pixel.y + places[lane].y - h.camera.centre_y);
        const glm::vec3 aside = u * h.right + v * h.down;
        const glm::vec3 from = perspective ? glm::vec3(0) : aside;
        const glm::vec3 to = perspective ? h.forward + aside : h.forward;
        valid[lane] = wanted[lane] ? -1 : 0;
        rays.ray.org_x[lane] = from.x;
        rays.ray.org_y[lane] = from.y;
        rays.ray.org_z[lane] = from.z;
        rays.ray.dir_x[lane] = to.x;
        rays.ray.dir_y[lane] = to.y;
        rays.ray.dir_z[lane] = to.z;
        rays.ray.tnear[lane] = static_cast<float>(h.camera.near_m);
        rays.ray.tfar[lane] = std::numeric_limits<float>::infinity();
        rays.ray.mask[lane] = 0xFFFFFFFFu;
        rays.ray.flags[lane] = 0;
        rays.ray.time[lane] = 0;
        rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid.data(), h.scene, &context, &rays);
    for (std::size_t lane = 0; lane < kPacket; ++lane)
        hits[lane] =
            rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID ? h.face_of[rays.hit.primID[lane]] : kNoFace;
}

}  // namespace keikan::baseline
