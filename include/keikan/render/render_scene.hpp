// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>

#include "keikan/image/image.hpp"
#include "keikan/render/shade.hpp"
#include "keikan/render/water_options.hpp"
#include "keikan/scan/scan_file.hpp"
#include "keikan/scan/scan_scene.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan {

struct RenderOptions {
    ScanOptions scan;
    WaterOptions water;                             ///< where the scene has water with a surface
    bool extra = false;                             ///< make all of ExtraImages
    std::function<void(int rows)> after_rows = {};  ///< told, from any thread, how many more rows are painted
    /// Not shade_scan_file: shown every band, from the top, one at a time.
    std::function<void(const ScanBand&)> after_band = {};
};

struct RenderedPicture {
    Image<Rgb> image;  ///< linear light
    ExtraImages extra;
    ScanStatistics scan;       ///< of render_scene
    double seconds_shade = 0;  ///< of render_scene: shading alone, summed over the bands
    WaterStatistics water;
};

/// A picture of this size, all black; with all of ExtraImages if `extra`.
RenderedPicture empty_picture(ImageSize size, bool extra);

/// The whole picture: scans the faces and shades each band as it comes.
/// Paper: section 2, Fig. 1.
RenderedPicture render_scene(const Scene& scene, const Geometry& geometry, const RenderOptions& options = {});

/// The same picture from a scan file, with the colours, materials and lights of `scene`. Faces are built only
/// where water mirrors them or the sun's shadows are drawn.
///
/// Property: (1) The same bits as render_scene with the options that the file was scanned with.
/// Errors: InputError naming the file, where it was made from another geometry, camera or size than the
///         scene's, or is damaged.
RenderedPicture shade_scan_file(const std::filesystem::path& file, const Scene& scene,
                                const RenderOptions& options = {});

}  // namespace keikan
