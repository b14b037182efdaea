// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "keikan/render/render_scene.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// A place where water is looked at by one ray, and how much of its pixel it stands for.
struct WaterPoint {
    int x = 0;  ///< the pixel
    int y = 0;
    std::uint16_t object = 0;
    Point at;  ///< pixel-local
    double weight = 0;
};

/// Rows of the picture that make one band.
struct BandRows {
    int first = 0;
    int count = 0;
};

/// Finds what the pixels of some rows show, by whatever method: fills `band`, and lists the places where it
/// looks at water, in any order. Points on objects that are not water, or that have no surface, add nothing;
/// water without points adds nothing where it has a surface.
using BandMaker = std::function<void(BandRows rows, ScanBand& band, std::vector<WaterPoint>& water)>;

/// A picture whose pixels are divided by another method than the scan: the same colours, light and water as
/// render_scene's. `new_maker` is called for each thread that works; a maker is used by one at a time.
/// Bands are made, and shaded, side by side. Of `options`: `water` (but for its numbers of samples), `extra`
/// and `after_rows`.
///
/// Properties:
///   (1) Where the makers' bands follow from their rows alone, the picture is the same for any number of
///       threads.
RenderedPicture render_bands(const Scene& scene, const Geometry& geometry, const ProjectedFaces& faces,
                             const std::function<BandMaker()>& new_maker, const RenderOptions& options);

/// Rows of the bands that render_bands asks for; the last may have fewer.
inline constexpr int kBandRows = 16;

}  // namespace keikan
