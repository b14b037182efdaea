// SPDX-License-Identifier: Apache-2.0
// Rays that drawing water sends to faces, a second, against Embree 3 alone on the same rays: in one process,
// in turns, one thread, processor time.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench_program.hpp"
#include "keikan/render/render_scene.hpp"
#include "keikan/render/scene_rays.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/parallel.hpp"
#include "keikan/water/face_rays.hpp"
#include "keikan/wave/counter_random.hpp"

namespace {

using namespace keikan;

struct Options {
    std::string scene = KEIKAN_SOURCE_DIR "/data/scenes/riverside.json";
    int width = 250, height = 162;
    double error = 3;
    int repeat = 5;
};

/// A pixel of water and how many samples drawing it took.
struct WaterPixel {
    PixelIndex at;
    std::uint16_t water;
    std::uint32_t samples;
};

struct Vertex {
    float x, y, z;
};

struct Triangle {
    std::uint32_t a, b, c;
};

/// Eight rays as Embree takes them, without what it fills in.
struct Packet {
    alignas(32) float origin[3][8], direction[3][8], farthest[8];
    alignas(32) int valid[8];
};

/// A call of Embree's for each: the rays of one call of ours are not mixed with those of another.
struct Recorded {
    std::vector<Packet> first_hits, sun;
    std::size_t rays = 0;
};

/// Embree's own hierarchy over the same faces, robust as ours.
class Hierarchy {
  public:
    Hierarchy(const Geometry& geometry, const glm::dvec3& origin) {
        device_ = rtcNewDevice("threads=1");
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        for (const Object& object : geometry.objects)
            if (object.kind != ObjectKind::Water) add(object.mesh, origin);
        rtcCommitScene(scene_);
    }
    ~Hierarchy() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Hierarchy(const Hierarchy&) = delete;
    Hierarchy& operator=(const Hierarchy&) = delete;

    /// Traces all rays; returns how many met a face.
    std::size_t trace(const Recorded& recorded) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t met = 0;
        for (const Packet& packet : recorded.first_hits) {
            RTCRayHit8 rays;
            set(rays.ray, packet);
            for (int i = 0; i < 8; ++i) rays.hit.geomID[i] = rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect8(packet.valid, scene_, &context, &rays);
            for (int i = 0; i < 8; ++i) met += rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
        for (const Packet& packet : recorded.sun) {
            RTCRay8 rays;
            set(rays, packet);
            rtcOccluded8(packet.valid, scene_, &context, &rays);
            for (int i = 0; i < 8; ++i) met += rays.tfar[i] < 0 ? 1 : 0;
        }
        return met;
    }

  private:
    void add(const Mesh& mesh, const glm::dvec3& origin) {
        std::vector<Triangle> corners_of;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const auto corners = mesh.face(f);
            for (std::size_t i = 2; i < corners.size(); ++i)
                corners_of.push_back({corners[0], corners[i - 1], corners[i]});
        }
        if (corners_of.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertex = static_cast<Vertex*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex), mesh.positions.size()));
        auto* triangle = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), corners_of.size()));
        for (const glm::dvec3& p : mesh.positions) {
            const glm::dvec3 q = p - origin;
            *vertex++ = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
        }
        std::copy(corners_of.begin(), corners_of.end(), triangle);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }
    static void set(RTCRay8& rays, const Packet& packet) {
        for (int i = 0; i < 8; ++i) {
            rays.org_x[i] = packet.origin[0][i];
            rays.org_y[i] = packet.origin[1][i];
            rays.org_z[i] = packet.origin[2][i];
            rays.dir_x[i] = packet.direction[0][i];
            rays.dir_y[i] = packet.direction[1][i];
            rays.dir_z[i] = packet.direction[2][i];
            rays.tnear[i] = static_cast<float>(FaceRays::kRayStart_m);
            rays.tfar[i] = packet.farthest[i];
            rays.time[i] = 0;
            rays.mask[i] = 0xFFFFFFFFu;
            rays.flags[i] = 0;
        }
    }
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
};

/// The pixels that show water and nothing else, as drawing the picture found them.
std::vector<WaterPixel> pixels_of(const Options& options, const Scene& scene, const Geometry& geometry) {
    RenderOptions drawing;
    drawing.extra = true;
    drawing.water.error = options.error;
    const RenderedPicture picture = render_scene(scene, geometry, drawing);
    std::vector<WaterPixel> pixels;
    for (int y = 0; y < picture.image.height(); ++y)
        for (int x = 0; x < picture.image.width(); ++x) {
            const auto samples = static_cast<std::uint32_t>(picture.extra.water_samples[PixelIndex{x, y}]);
            if (samples > 0) pixels.push_back({{x, y}, 0, samples});
        }
    return pixels;
}

/// Draws the water of all pixels: their waves, Sobol's points, what the rays see. `after` sees each call.
template <typename After>
double draw(const std::vector<WaterPixel>& pixels, WaterSampler& sampler, const After& after) {
    std::vector<Point> places, slopes, suns;
    std::vector<Rgb> colours;
    double sum = 0;
    for (const WaterPixel& pixel : pixels) {
        sampler.look_at(pixel.at, pixel.water);
        const auto key = [&](std::uint32_t purpose) { return random_key(pixel.at.x, pixel.at.y, purpose); };
        const std::uint64_t place = key(1), slope = key(2), sun = key(5);
        // As the picture is drawn: 16 first, then what the error asks for.
        for (std::uint32_t begin = 0, end = 0; begin < pixel.samples; begin = end) {
            end = std::min(pixel.samples, begin == 0 ? 16 : 4 * begin);
            places.clear();
            slopes.clear();
            suns.clear();
            for (std::uint32_t i = begin; i < end; ++i) {
                places.push_back(i % kSlopesOfAPlace == 0 ? scrambled_sobol(i / kSlopesOfAPlace, place)
                                                          : places.back());
                slopes.push_back(scrambled_sobol(i, slope));
                suns.push_back(shuffled_sobol(i, sun));
            }
            colours.resize(places.size());
            sampler.colours(places, slopes, suns, colours, SlopeOrder::ByRank);
            for (const Rgb& c : colours) sum += static_cast<double>(c.g);
            after();
        }
    }
    return sum;
}

void record(std::span<const FaceRay> rays, const glm::dvec3& origin, std::vector<Packet>& packets) {
    for (std::size_t begin = 0; begin < rays.size(); begin += 8) {
        Packet& packet = packets.emplace_back();
        for (std::size_t i = 0; i < 8; ++i) {
            const FaceRay& ray = rays[std::min(begin + i, rays.size() - 1)];
            const glm::dvec3 from = ray.origin - origin;
            packet.valid[i] = begin + i < rays.size() ? -1 : 0;
            packet.farthest[i] = static_cast<float>(ray.farthest_m);
            for (int axis = 0; axis < 3; ++axis) {
                packet.origin[axis][i] = static_cast<float>(from[axis]);
                packet.direction[axis][i] = static_cast<float>(ray.direction[axis]);
            }
        }
    }
}

template <typename Work>
double processor_seconds(const Work& work) {
    const std::clock_t spent = std::clock();
    work();
    return static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

int run(const Options& options) {
    const ThreadLimit one(1);
    const Scene scene = read_scene(options.scene, ImageSize{options.width, options.height});
    const Geometry geometry = build_geometry(scene);
    const std::vector<WaterPixel> pixels = pixels_of(options, scene, geometry);
    const SceneRays rays(scene, geometry);
    WaterSampler sampler(rays);
    Recorded recorded;
    draw(pixels, sampler, [&] {
        record(sampler.first_hit_rays(), scene.camera.position, recorded.first_hits);
        record(sampler.sun_rays(), scene.camera.position, recorded.sun);
        recorded.rays += sampler.first_hit_rays().size() + sampler.sun_rays().size();
    });
    const std::uint64_t samples = sampler.statistics().samples;
    const Hierarchy hierarchy(geometry, scene.camera.position);
    std::vector<double> ours, embree, ratios;
    double light = 0;
    std::size_t met = 0;
    for (int i = 0; i < options.repeat; ++i) {
        ours.push_back(processor_seconds([&] { light += draw(pixels, sampler, [] {}); }));
        embree.push_back(processor_seconds([&] { met += hierarchy.trace(recorded); }));
        ratios.push_back(embree.back() / ours.back());
    }
    if (!(light > 0) || met == 0) throw std::runtime_error("no water is seen");
    const auto n = static_cast<double>(recorded.rays), of = static_cast<double>(samples);
    fmt::print(
        "{}: {} x {}, {} pixels of water, {:.1f} samples each, {:.2f} rays to faces a sample; "
        "one thread, processor time, median of {}\n\n",
        scene.file.filename().string(), scene.camera.size.width, scene.camera.size.height, pixels.size(),
        of / static_cast<double>(pixels.size()), n / of, options.repeat);
    fmt::print("| rays to faces | a sample, us | million a second | of Embree's |\n|---|---:|---:|---:|\n");
    const auto row = [&](const char* what, double seconds, double share) {
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} |\n", what, 1e6 * seconds / of, 1e-6 * n / seconds,
                   share);
    };
    row("keikan: points, waves, slopes, rays, light", median(ours), median(ratios));
    row("Embree 3 alone: the same rays in packets of 8", median(embree), 1);
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    CLI::App app("Drawing water against Embree 3 alone on the same rays");
    app.add_option("scene", options.scene, "scene file")->capture_default_str();
    app.add_option("--width", options.width, "columns of the picture")->capture_default_str();
    app.add_option("--height", options.height, "rows of the picture")->capture_default_str();
    app.add_option("--water-error", options.error, "as of keikan render")->capture_default_str();
    app.add_option("--repeat", options.repeat, "turns")->capture_default_str()->check(CLI::Range(1, 1000));
    return bench::run_program(app, count, arguments, [&] { return run(options); });
}
