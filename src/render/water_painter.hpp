// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "keikan/image/image.hpp"
#include "keikan/render/render_bands.hpp"
#include "keikan/render/scene_rays.hpp"
#include "keikan/render/water_options.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scene/scene.hpp"
#include "water_pixels.hpp"

namespace keikan {

/// Adds the colours of the water to the pixels of `image`, which hold the shares of all that is not water
/// already (MixedPixels::Paper: replaces them).
///
/// A water region is what the visible areas leave to the water's faces; samples are uniform on it.
///
/// Properties:
///   (1) A pixel's colour follows from scene, geometry and options alone: not from other pixels or the number
///   of
///       threads. Random numbers are keyed by the pixel.
///   (2) The samples of a divided pixel lie in the region of the pixel that shows the water.
///   (3) WaterMode::Variance: where the mirror image of a thin conductor may be (MirroredWires), 64 samples
///       are taken on it alone, which count as much as its area; the colour stays without bias.
class WaterPainter {
  public:
    /// Requires: all five outlive it.
    WaterPainter(const Scene& scene, const Geometry& geometry, const SceneRays& rays,
                 const ProjectedFaces& faces, const WaterOptions& options);
    ~WaterPainter();

    /// Before any list is painted in WaterMode::Variance: measures how well samples do, in some pixels of all
    /// of them, and finds where thin conductors are mirrored.
    void measure(std::span<const WaterPixels> lists);
    /// The pixels of a list, side by side; those outside of options.window are left alone. `counts`, where
    /// given, holds each pixel's samples afterwards.
    void paint(const WaterPixels& list, Image<Rgb>& image, Image<float>* counts = nullptr);
    /// Adds `weight` times the colour of the water at each point, slopes being random. On this thread; may be
    /// called by several at once, for different pixels.
    ///
    /// Requires: points of a pixel stand together. Of objects that are not water (kNoWater) they are left
    /// out.
    void paint(std::span<const WaterPoint> points, std::span<const std::uint16_t> water_of_object,
               Image<Rgb>& image);

    /// What was counted so far; `seconds` is not.
    WaterStatistics statistics() const;

  private:
    struct Working;
    std::unique_ptr<Working> working_;
};

/// All of it at once.
WaterStatistics paint_water(std::span<const WaterPixels> pixels, const Scene& scene, const Geometry& geometry,
                            const SceneRays& rays, const ProjectedFaces& faces, const WaterOptions& options,
                            Image<Rgb>& image, Image<float>* counts);

}  // namespace keikan
