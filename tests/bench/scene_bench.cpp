// SPDX-License-Identifier: Apache-2.0
// keikan against Embree 3: the same faces, the same threads, in one process, in turns.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "bench_program.hpp"
#include "embree_render.hpp"
#include "keikan/render/render_scene.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/parallel.hpp"
#include "multi_object_pixels.hpp"

namespace {

using namespace keikan;
using Clock = std::chrono::steady_clock;

struct Options {
    std::string scene = KEIKAN_SOURCE_DIR "/data/scenes/ridge_line.json";
    int threads = 1;
    int repeat = 5;
    bool processor_time = false;
};

constexpr std::array<int, 3> kSides{1, 2, 4};  ///< 1, 4 and 16 samples a pixel

struct Timings {
    std::vector<double> keikan;
    std::vector<double> hierarchy;
    std::array<std::vector<double>, kSides.size()> rays;
    ScanStatistics statistics;
    double keikan_peak_mib = 0;
};

/// Wall seconds of `work`, or those that the processors spent in all threads.
template <typename Work>
double seconds_of(const Options& options, const Work& work) {
    const std::clock_t spent = std::clock();
    const Clock::time_point start = Clock::now();
    work();
    const double wall = std::chrono::duration<double>(Clock::now() - start).count();
    return options.processor_time ? static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC : wall;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// The largest memory that this process has held, 0 where the system does not say.
double peak_mib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
    return 0;
}

Timings measure(const Options& options, const Scene& scene, const Geometry& geometry) {
    const ThreadLimit limit(options.threads);
    Timings timings;
    Image<Rgb> image(scene.camera.size);
    render_scene(scene, geometry);  // warms up, before Embree holds any memory
    timings.keikan_peak_mib = peak_mib();

    bench::EmbreeRender embree(geometry, scene.camera, options.threads);
    embree.build();
    embree.trace(1, image);
    for (int i = 0; i < options.repeat; ++i) {
        timings.keikan.push_back(
            seconds_of(options, [&] { timings.statistics = render_scene(scene, geometry).scan; }));
        timings.hierarchy.push_back(seconds_of(options, [&] { embree.build(); }));
        for (std::size_t s = 0; s < kSides.size(); ++s)
            timings.rays[s].push_back(seconds_of(options, [&] { embree.trace(kSides[s], image); }));
    }
    return timings;
}

void print(const Options& options, const Scene& scene, const Geometry& geometry, const Timings& timings) {
    const double keikan = median(timings.keikan);
    const ScanStatistics& s = timings.statistics;
    fmt::print("{}: {} faces, {} seen by the camera, {} x {} pixels, {} thread{}, median of {}{}\n\n",
               scene.file.filename().string(), geometry.first_face.back(), s.faces, scene.camera.size.width,
               scene.camera.size.height, options.threads, options.threads == 1 ? "" : "s", options.repeat,
               options.processor_time ? ", processor time" : "");
    fmt::print("| whole picture from the faces | seconds | of keikan's |\n|---|---:|---:|\n");
    fmt::print("| keikan: project, bin, exact areas, shade | {:.3f} | 1.00 |\n", keikan);
    const double hierarchy = median(timings.hierarchy);
    for (std::size_t i = 0; i < kSides.size(); ++i) {
        const double embree = hierarchy + median(timings.rays[i]);
        fmt::print("| Embree 3: hierarchy {:.3f} + rays {:.3f}, {} a pixel | {:.3f} | {:.2f} |\n", hierarchy,
                   median(timings.rays[i]), kSides[i] * kSides[i], embree, embree / keikan);
    }
    if (!options.processor_time)
        fmt::print("\nkeikan, last turn: project {:.3f} s, bin {:.3f} s, divide {:.3f} s", s.seconds_project,
                   s.seconds_bin, s.seconds_divide);
    fmt::print("\nkeikan's peak memory, scene included: {:.0f} MiB\n", timings.keikan_peak_mib);
    fmt::print("pixels divided by exact areas: {}, with several objects: {}, parts: {}\n", s.divided_pixels,
               s.multi_object_pixels, s.parts);
}

void print_pixels(const std::vector<double>& seconds) {
    if (seconds.empty()) return;
    const auto at = [&](double q) {
        return 1e6 * seconds[static_cast<std::size_t>(q * static_cast<double>(seconds.size() - 1))];
    };
    const double sum = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    fmt::print(
        "exact areas of a pixel that shows several objects, one thread, us: "
        "mean {:.2f}, median {:.2f}, 99 % {:.1f}, largest {:.0f} ({} pixels)\n",
        1e6 * sum / static_cast<double>(seconds.size()), at(0.5), at(0.99), at(1), seconds.size());
}

int run(const Options& options) {
    const Scene scene = read_scene(options.scene);
    const Geometry geometry = build_geometry(scene);
    print(options, scene, geometry, measure(options, scene, geometry));
    const ThreadLimit one(1);
    print_pixels(bench::seconds_of_multi_object_pixels(geometry, scene.camera));
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    CLI::App app("keikan against Embree 3 on the same faces");
    app.add_option("scene", options.scene, "scene file")->capture_default_str();
    app.add_option("--threads", options.threads, "threads of either")
        ->capture_default_str()
        ->check(CLI::Range(1, 1024));
    app.add_option("--repeat", options.repeat, "turns")->capture_default_str()->check(CLI::Range(1, 1000));
    app.add_flag("--processor-time", options.processor_time,
                 "not wall time: for a machine that is busy otherwise");
    return bench::run_program(app, count, arguments, [&] { return run(options); });
}
