// SPDX-License-Identifier: Apache-2.0
#include "keikan/render/render_bands.hpp"

#include <algorithm>
#include <optional>

#include "keikan/render/shade.hpp"
#include "keikan/support/parallel.hpp"
#include "water_painter.hpp"

namespace keikan {

namespace {

/// What one thread works with.
struct Bench {
    BandMaker make;
    ScanBand band;
    std::vector<WaterPoint> points;
};

void put_pixels_together(std::vector<WaterPoint>& points) {
    std::stable_sort(points.begin(), points.end(), [](const WaterPoint& p, const WaterPoint& q) {
        return p.y != q.y ? p.y < q.y : p.x < q.x;
    });
}

void count(const ScanBand& band, ScanStatistics& counted) {
    counted.parts += band.parts.size();
    for (const DividedPixel& pixel : band.divided) {
        ++(pixel.division == Division::ExactAreas ? counted.divided_pixels : counted.scanline_pixels);
        const auto object = [&](std::uint32_t part) { return band.faces[band.parts[part].face].object; };
        bool several = pixel.background > 0;
        for (std::uint32_t p = pixel.part_begin; p < pixel.part_end; ++p)
            several |= object(p) != object(pixel.part_begin);
        counted.multi_object_pixels += several;
    }
}

}  // namespace

RenderedPicture render_bands(const Scene& scene, const Geometry& geometry, const ProjectedFaces& faces,
                             const std::function<BandMaker()>& new_maker, const RenderOptions& options) {
    const ImageSize size = scene.camera.size;
    RenderedPicture picture = empty_picture(size, options.extra);
    const std::vector<std::uint16_t> water_of = water_of_objects(scene, geometry);
    std::optional<WaterPixels> water;
    std::optional<WaterPainter> painter;
    std::optional<SceneRays> rays;
    if (scene.light.shadows != Shadows::Off) rays.emplace(scene, geometry);
    if (options.water.mode != WaterMode::Flat && has_water_surfaces(scene)) {
        water.emplace(water_of, true);
        if (!rays) rays.emplace(scene, geometry);
        painter.emplace(scene, geometry, *rays, faces, options.water);
    }
    const auto bands = static_cast<std::size_t>((size.height + kBandRows - 1) / kBandRows);
    const auto threads = static_cast<std::size_t>(thread_count());
    std::vector<Bench> benches(threads == 1 ? 1 : 2 * threads);
    parallel_in_order(
        bands, benches.size(),
        [&](std::size_t i, std::size_t slot) {
            Bench& bench = benches[slot];
            if (!bench.make) bench.make = new_maker();
            const int first = static_cast<int>(i) * kBandRows;
            bench.points.clear();
            bench.make({first, std::min(kBandRows, size.height - first)}, bench.band, bench.points);
            shade_band(bench.band, scene, picture.image, options.extra ? &picture.extra : nullptr,
                       water ? &*water : nullptr, rays ? &*rays : nullptr);
            if (!painter) return;
            put_pixels_together(bench.points);
            painter->paint(bench.points, water_of, picture.image);
        },
        [&](std::size_t, std::size_t slot) {
            count(benches[slot].band, picture.scan);
            if (options.after_band) options.after_band(benches[slot].band);
            if (options.after_rows) options.after_rows(benches[slot].band.rows);
        });
    picture.scan.faces = faces.size();
    if (painter) picture.water = painter->statistics();
    return picture;
}

}  // namespace keikan
