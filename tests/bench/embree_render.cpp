// SPDX-License-Identifier: Apache-2.0
#include "embree_render.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan::bench {
namespace {

constexpr int kPacketColumns = 4;
constexpr int kPacketRows = 2;
constexpr int kPacket = kPacketColumns * kPacketRows;
constexpr Rgb kSky{0.6f, 0.7f, 0.9f};

struct Vertex {
    float x, y, z;
};

struct Triangle {
    std::uint32_t a, b, c;
};

/// A counter-based random number in [0, 1): the same for every run and any number of threads.
float jitter(std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
    std::uint32_t h = x * 0x9E3779B1u ^ (y * 0x85EBCA77u + 0x165667B1u) ^ sample * 0xC2B2AE3Du;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    h ^= h >> 12;
    h *= 0x297A2D39u;
    h ^= h >> 15;
    return static_cast<float>(h >> 8) * 0x1p-24f;
}

/// Any colour will do as long as it is stored, one for each face.
Rgb colour_of(std::uint32_t face) {
    return {jitter(face, 1, 0), jitter(face, 2, 0), jitter(face, 3, 0)};
}

}  // namespace

struct EmbreeRender::Working {
    Camera camera;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    RTCGeometry geometry = nullptr;
    std::vector<Rgb> colour;  ///< one for each triangle
};

EmbreeRender::EmbreeRender(const Geometry& geometry, const Camera& camera, int threads)
    : working_(std::make_unique<Working>()) {
    Working& work = *working_;
    work.camera = camera;
    const std::string settings = "threads=" + std::to_string(threads);
    work.device = rtcNewDevice(settings.c_str());
    KEIKAN_CHECK(work.device != nullptr, "Embree gives no device for " << settings);

    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (const Object& object : geometry.objects) {
        vertices += object.mesh.positions.size();
        for (std::size_t f = 0; f < object.mesh.face_count(); ++f)
            triangles += object.mesh.face(f).size() - 2;
    }
    work.geometry = rtcNewGeometry(work.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<Vertex*>(rtcSetNewGeometryBuffer(work.geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                RTC_FORMAT_FLOAT3, sizeof(Vertex), vertices));
    auto* triangle = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
        work.geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), triangles));
    work.colour.reserve(triangles);

    std::uint32_t base = 0;
    std::uint32_t face_id = 0;
    for (const Object& object : geometry.objects) {
        for (const glm::dvec3& p : object.mesh.positions) {
            const glm::dvec3 q = p - camera.position;
            *vertex++ = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
        }
        for (std::size_t f = 0; f < object.mesh.face_count(); ++f, ++face_id) {
            const auto corners = object.mesh.face(f);
            for (std::size_t i = 2; i < corners.size(); ++i) {
                *triangle++ = {base + corners[0], base + corners[i - 1], base + corners[i]};
                work.colour.push_back(colour_of(face_id));
            }
        }
        base += static_cast<std::uint32_t>(object.mesh.positions.size());
    }
    rtcCommitGeometry(work.geometry);
}

EmbreeRender::~EmbreeRender() {
    if (working_->scene != nullptr) rtcReleaseScene(working_->scene);
    if (working_->geometry != nullptr) rtcReleaseGeometry(working_->geometry);
    if (working_->device != nullptr) rtcReleaseDevice(working_->device);
}

void EmbreeRender::build() {
    Working& work = *working_;
    if (work.scene != nullptr) rtcReleaseScene(work.scene);
    work.scene = rtcNewScene(work.device);
    rtcAttachGeometry(work.scene, work.geometry);
    rtcCommitScene(work.scene);
    KEIKAN_CHECK(rtcGetDeviceError(work.device) == RTC_ERROR_NONE, "Embree could not build its hierarchy");
}

namespace {

/// One packet: a ray through each of its pixels, at the jittered place `sample` of the stratum (sx, sy).
struct PacketRays {
    alignas(32) std::array<int, kPacket> valid{};
    RTCRayHit8 rays{};
};

struct Stratum {
    int sx;
    int sy;
    int side;
};

void aim(PacketRays& packet, const Camera& camera, int x0, int y0, Stratum stratum) {
    const std::uint32_t sample = static_cast<std::uint32_t>(stratum.sy * stratum.side + stratum.sx);
    const float width = 1.0f / static_cast<float>(stratum.side);
    const bool perspective = camera.kind == Camera::Kind::Perspective;
    const float scale = static_cast<float>(1 / camera.focal_px);
    const auto right = glm::vec3(camera.right) * scale;
    const auto down = glm::vec3(camera.down) * scale;
    const auto forward = glm::vec3(camera.forward);
    for (int i = 0; i < kPacket; ++i) {
        const int x = x0 + i % kPacketColumns;
        const int y = y0 + i / kPacketColumns;
        const auto column = static_cast<std::uint32_t>(x);
        const auto row = static_cast<std::uint32_t>(y);
        const float px = static_cast<float>(x) +
                         (static_cast<float>(stratum.sx) + jitter(column, row, 2 * sample)) * width;
        const float py = static_cast<float>(y) +
                         (static_cast<float>(stratum.sy) + jitter(column, row, 2 * sample + 1)) * width;
        const glm::vec3 aside = right * (px - static_cast<float>(camera.centre_x)) +
                                down * (py - static_cast<float>(camera.centre_y));
        const glm::vec3 from = perspective ? glm::vec3(0) : aside;
        const glm::vec3 to = perspective ? forward + aside : forward;
        packet.valid[static_cast<std::size_t>(i)] = x < camera.size.width && y < camera.size.height ? -1 : 0;
        RTCRay8& ray = packet.rays.ray;
        ray.org_x[i] = from.x;
        ray.org_y[i] = from.y;
        ray.org_z[i] = from.z;
        ray.dir_x[i] = to.x;
        ray.dir_y[i] = to.y;
        ray.dir_z[i] = to.z;
        ray.tnear[i] = static_cast<float>(camera.near_m);
        ray.tfar[i] = std::numeric_limits<float>::infinity();
        ray.mask[i] = 0xFFFFFFFFu;
        ray.flags[i] = 0;
        ray.time[i] = 0;
        packet.rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
}

}  // namespace

void EmbreeRender::trace(int side, Image<Rgb>& image) const {
    const Working& work = *working_;
    const auto packet_rows = static_cast<std::size_t>((image.height() + kPacketRows - 1) / kPacketRows);
    parallel_for(packet_rows, [&](std::size_t packet_row) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        PacketRays packet;
        const int y0 = static_cast<int>(packet_row) * kPacketRows;
        const float share = 1.0f / static_cast<float>(side * side);
        for (int x0 = 0; x0 < image.width(); x0 += kPacketColumns) {
            std::array<Rgb, kPacket> sum{};
            for (int s = 0; s < side * side; ++s) {
                aim(packet, work.camera, x0, y0, {s % side, s / side, side});
                rtcIntersect8(packet.valid.data(), work.scene, &context, &packet.rays);
                for (std::size_t i = 0; i < kPacket; ++i) {
                    const bool hit = packet.rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
                    sum[i] = sum[i] + (hit ? work.colour[packet.rays.hit.primID[i]] : kSky);
                }
            }
            for (int i = 0; i < kPacket; ++i) {
                const PixelIndex pixel{x0 + i % kPacketColumns, y0 + i / kPacketColumns};
                if (pixel.x < image.width() && pixel.y < image.height())
                    image[pixel] = share * sum[static_cast<std::size_t>(i)];
            }
        }
    });
}

}  // namespace keikan::bench
