// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/render/scene_rays.hpp"
#include "keikan/render/water_options.hpp"
#include "keikan/wave/counter_random.hpp"
#include "mirrored_wires.hpp"
#include "near_variance.hpp"
#include "sample_places.hpp"
#include "sample_sums.hpp"
#include "sobol_gain.hpp"
#include "water_region.hpp"

namespace keikan {

/// What is found out before any pixel is painted.
struct WaterMeasures {
    explicit WaterMeasures(ImageSize size) : gain(size), near(size), wires(size) {}
    SobolGain gain;
    NearVariance near;
    MirroredWires wires;
};

/// The mean colour of water over a region of a pixel, by as many samples as WaterOptions ask for. One for
/// each thread; owns the memory that this needs.
class RegionSampler {
  public:
    /// Requires: all three outlive it.
    RegionSampler(const SceneRays& rays, const WaterOptions& options, const WaterMeasures& measures);

    /// The mean over the region of this pixel, which shows this water; `weight` is its share of the pixel,
    /// whose other shares are `base`.
    Rgb colour(PixelIndex pixel, std::uint16_t water, const WaterRegion& region, double weight, Rgb base);
    /// How many samples the last colour took.
    std::uint64_t count() const { return count_; }

    /// How single samples, and blocks of Sobol's points, vary in a pixel that shows this water and nothing
    /// else.
    SobolGain::Note note(PixelIndex pixel, std::uint16_t water);

    /// Slopes and suns for points of one pixel that someone else has chosen, independent of one another.
    void begin_points(PixelIndex pixel);
    /// The colours at these points of the pixel, for the next slopes and suns.
    std::span<const Rgb> colours_at(std::uint16_t water, std::span<const Point> points);

    const WaterStatistics& statistics() const { return sampler_.statistics(); }

  private:
    std::uint64_t key(std::uint32_t purpose) const;
    void look_at(PixelIndex pixel, std::uint16_t water, const WaterRegion& region);
    void take(SampleSums& sums, SlopeOrder order, SampleSums* codes = nullptr);
    void take_sobol(std::size_t begin, std::size_t end, SampleSums& sums);
    void take_points_of(Sampler sampler, std::size_t count, bool second, SampleSums& sums, SampleSums* codes);
    template <typename Take>
    void sample_to_error(double weight, Rgb base, std::size_t most, SampleSums& sums, const Take& take);
    Rgb colour_to_error(double weight, Rgb base);
    Rgb colour_beside_wires(double weight, Rgb base);
    void take_places(SamplePlaces::Part part, std::size_t count, CounterRandom& choice, SampleSums& sums);
    void sample_as_the_paper(SampleSums& sums);

    const WaterOptions& options_;
    const WaterMeasures& measures_;
    WaterSampler sampler_;
    PixelIndex at_;
    const WaterRegion* region_ = nullptr;
    std::uint64_t count_ = 0;
    std::uint32_t placed_ = 0;  ///< samples that take_places took of this pixel
    SamplePlaces places_;
    std::vector<const MirroredWires::Strip*> strips_;
    CounterRandom slope_numbers_{0}, sun_numbers_{0};  ///< of begin_points
    std::vector<Point> positions_, slopes_, suns_;
    std::vector<Rgb> colours_, noted_;
};

}  // namespace keikan
