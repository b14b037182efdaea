// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/render/render_bands.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "region_sampler.hpp"
#include "water_pixels.hpp"

namespace keikan {

/// Draws pixels that hold water, one after the other: finds the water's region of each, and adds its colour.
/// One for each thread.
class PixelPainter {
  public:
    /// Requires: all four outlive it.
    PixelPainter(const SceneRays& rays, const ProjectedFaces& faces, const WaterOptions& options,
                 const WaterMeasures& measures)
        : faces_(faces), options_(options), sampler_(rays, options, measures) {}

    /// The samples that it took. `colour` holds the shares of all that is not water.
    std::uint64_t paint(const WaterPixels& all, const WaterPixels::Pixel& pixel, Rgb& colour);

    /// Adds the water of one pixel's points, each by its weight.
    void paint_points(std::span<const WaterPoint> points, std::span<const std::uint16_t> water_of_object,
                      Rgb& colour);

    /// Of a pixel that shows one water and nothing else.
    SobolGain::Note note(const WaterPixels::Pixel& pixel) {
        return sampler_.note({pixel.x, pixel.y}, pixel.water);
    }

    WaterStatistics statistics() const;

  private:
    void count_samples(std::uint64_t samples);
    void paint_divided(std::span<const WaterPixels::Part> parts, Rgb& colour);
    void paint_regions(std::span<const WaterPixels::Part> parts, Rgb& colour);
    Rgb water_colour(std::uint16_t water, double weight, Rgb base);

    const ProjectedFaces& faces_;
    const WaterOptions& options_;
    RegionSampler sampler_;
    WaterStatistics statistics_;
    std::uint64_t samples_of_pixel_ = 0;
    PixelIndex at_;
    WaterRegion region_;
    VisibleAreas visible_areas_;
    std::vector<FaceView> asked_;
    std::vector<Point> positions_;
};

}  // namespace keikan
