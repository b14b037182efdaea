// SPDX-License-Identifier: Apache-2.0
#include "keikan/render/render_scene.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "keikan/render/scene_rays.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "water_painter.hpp"

namespace keikan {

RenderedPicture empty_picture(ImageSize size, bool extra) {
    RenderedPicture picture;
    picture.image = Image<Rgb>(size);
    if (extra)
        picture.extra = {Image<float>(size), Image<float>(size), Image<float>(size), Image<float>(size),
                         Image<float>(size)};
    return picture;
}

namespace {

void paint(const ScanBand& band, const Scene& scene, const RenderOptions& options, RenderedPicture& picture,
           WaterPixels* water, const SceneRays* rays) {
    shade_band(band, scene, picture.image, options.extra ? &picture.extra : nullptr, water, rays);
    if (options.after_rows) options.after_rows(band.rows);
}

std::string text_of(ImageSize size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// The scan must be of this scene; its extraction is what it was scanned with.
void require_same_geometry(const ScanHeader& header, const Scene& scene, const std::string& file) {
    if (header.size != scene.camera.size)
        throw InputError(
            file, "",
            "was scanned at " + text_of(header.size) + ", the scene is " + text_of(scene.camera.size));
    if (header.geometry_hash != scene.geometry_hash)
        throw InputError(file, "", "was scanned from another geometry or camera than " + scene.file.string());
}

bool draws_water(const Scene& scene, const RenderOptions& options) {
    return options.water.mode != WaterMode::Flat && has_water_surfaces(scene);
}

bool needs_rays(const Scene& scene, const RenderOptions& options) {
    return scene.light.shadows != Shadows::Off || draws_water(scene, options);
}

}  // namespace

RenderedPicture render_scene(const Scene& scene, const Geometry& geometry, const RenderOptions& options) {
    using Clock = std::chrono::steady_clock;
    const auto started = Clock::now();
    RenderedPicture picture = empty_picture(scene.camera.size, options.extra);
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    const double seconds_project = std::chrono::duration<double>(Clock::now() - started).count();
    std::optional<WaterPixels> water;
    std::optional<SceneRays> rays;
    if (needs_rays(scene, options)) rays.emplace(scene, geometry);
    if (draws_water(scene, options)) water.emplace(water_of_objects(scene, geometry));
    picture.scan = scan_faces(faces, geometry, scene.camera, options.scan, [&](const ScanBand& band) {
        const auto begin = Clock::now();
        paint(band, scene, options, picture, water ? &*water : nullptr, rays ? &*rays : nullptr);
        if (options.after_band) options.after_band(band);
        picture.seconds_shade += std::chrono::duration<double>(Clock::now() - begin).count();
    });
    picture.scan.seconds_project += seconds_project;
    if (water)
        picture.water = paint_water(std::span(&*water, 1), scene, geometry, *rays, faces, options.water,
                                    picture.image, options.extra ? &picture.extra.water_samples : nullptr);
    return picture;
}

RenderedPicture shade_scan_file(const std::filesystem::path& file, const Scene& scene,
                                const RenderOptions& options) {
    const ScanFileReader scan(file);
    require_same_geometry(scan.header(), scene, file.string());
    RenderedPicture picture = empty_picture(scene.camera.size, options.extra);
    if (!needs_rays(scene, options)) {
        parallel_for(scan.band_count(),
                     [&](std::size_t i) { paint(scan.band(i), scene, options, picture, nullptr, nullptr); });
        return picture;
    }
    const Geometry geometry = build_geometry(scene);
    const SceneRays rays(scene, geometry);
    if (!draws_water(scene, options)) {
        parallel_for(scan.band_count(),
                     [&](std::size_t i) { paint(scan.band(i), scene, options, picture, nullptr, &rays); });
        return picture;
    }
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    std::vector<WaterPixels> water(scan.band_count(), WaterPixels(water_of_objects(scene, geometry)));
    parallel_for(scan.band_count(),
                 [&](std::size_t i) { paint(scan.band(i), scene, options, picture, &water[i], &rays); });
    picture.water = paint_water(water, scene, geometry, rays, faces, options.water, picture.image,
                                options.extra ? &picture.extra.water_samples : nullptr);
    return picture;
}

}  // namespace keikan
