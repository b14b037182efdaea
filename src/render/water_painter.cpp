// SPDX-License-Identifier: Apache-2.0
#include "water_painter.hpp"

#include <algorithm>
#include <chrono>

#include "keikan/support/parallel.hpp"
#include "pixel_painter.hpp"
#include "water_counts.hpp"

namespace keikan {

/// What outlives a list of pixels.
struct WaterPainter::Working {
    const Scene& scene;
    const Geometry& geometry;
    const ProjectedFaces& faces;
    const WaterOptions& options;
    const SceneRays& rays;
    WaterMeasures measures;
    WaterCounts counts{};

    PixelPainter painter() const { return {rays, faces, options, measures}; }
};

WaterPainter::WaterPainter(const Scene& scene, const Geometry& geometry, const SceneRays& rays,
                           const ProjectedFaces& faces, const WaterOptions& options)
    : working_(new Working{scene, geometry, faces, options, rays, WaterMeasures(scene.camera.size)}) {}

WaterPainter::~WaterPainter() = default;

void WaterPainter::measure(std::span<const WaterPixels> lists) {
    if (working_->options.mode != WaterMode::Variance) return;
    std::vector<WaterPixels::Pixel> chosen;
    for (const WaterPixels& list : lists)
        for (const WaterPixels::Pixel& pixel : list.pixels())
            if (pixel.water != kNoWater && SobolGain::measures({pixel.x, pixel.y})) chosen.push_back(pixel);
    std::sort(chosen.begin(), chosen.end(),
              [](const auto& p, const auto& q) { return std::pair(p.y, p.x) < std::pair(q.y, q.x); });
    std::vector<SobolGain::Note> notes(chosen.size());
    constexpr std::size_t kPixelsPerRun = 64;
    parallel_ranges(chosen.size(), kPixelsPerRun, [&](std::size_t first, std::size_t end) {
        PixelPainter painter = working_->painter();
        for (std::size_t i = first; i < end; ++i) notes[i] = painter.note(chosen[i]);
        WaterStatistics taken = painter.statistics();
        std::swap(taken.measuring_samples, taken.samples);
        working_->counts.add(taken);
    });
    working_->measures.gain.settle(notes);
    working_->measures.near.settle(notes);
    working_->measures.wires = MirroredWires(working_->scene, working_->geometry);
}

void WaterPainter::paint(const WaterPixels& list, Image<Rgb>& image, Image<float>* counts) {
    // Far pixels need other times than near ones: short runs share the work evenly.
    constexpr std::size_t kPixelsPerRun = 128;
    const auto all = list.pixels();
    parallel_ranges(all.size(), kPixelsPerRun, [&](std::size_t first, std::size_t end) {
        PixelPainter painter = working_->painter();
        const auto& window = working_->options.window;
        for (std::size_t i = first; i < end; ++i) {
            const PixelIndex at{all[i].x, all[i].y};
            if (window && !window->holds(at)) continue;
            const std::uint64_t samples = painter.paint(list, all[i], image[at]);
            if (counts != nullptr) (*counts)[at] = static_cast<float>(samples);
        }
        working_->counts.add(painter.statistics());
    });
}

void WaterPainter::paint(std::span<const WaterPoint> points, std::span<const std::uint16_t> water_of_object,
                         Image<Rgb>& image) {
    PixelPainter painter = working_->painter();
    for (std::size_t first = 0; first < points.size();) {
        const PixelIndex pixel{points[first].x, points[first].y};
        std::size_t end = first + 1;
        while (end < points.size() && points[end].x == pixel.x && points[end].y == pixel.y) ++end;
        painter.paint_points(points.subspan(first, end - first), water_of_object, image[pixel]);
        first = end;
    }
    working_->counts.add(painter.statistics());
}

WaterStatistics WaterPainter::statistics() const {
    return working_->counts.sums();
}

WaterStatistics paint_water(std::span<const WaterPixels> pixels, const Scene& scene, const Geometry& geometry,
                            const SceneRays& rays, const ProjectedFaces& faces, const WaterOptions& options,
                            Image<Rgb>& image, Image<float>* counts) {
    const auto begin = std::chrono::steady_clock::now();
    WaterPainter painter(scene, geometry, rays, faces, options);
    painter.measure(pixels);
    for (const WaterPixels& list : pixels) painter.paint(list, image, counts);
    WaterStatistics statistics = painter.statistics();
    statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return statistics;
}

}  // namespace keikan
