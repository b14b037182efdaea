// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/pixel.hpp"
#include "keikan/wave/counter_random.hpp"
#include "mirrored_wires.hpp"
#include "water_region.hpp"

namespace keikan {

/// Where the samples of a region of a pixel may be, parted into those on strips of MirroredWires and those
/// beside them, so that each part is sampled by itself: the mean over the region is the sum of the parts'
/// means, each times its share.
///
/// Properties:
///   (1) The places are the first kPlaces of Sobol's points, keyed by the pixel: shares are unbiased, and off
///       by about 0.003 of the region where a strip crosses it.
///   (2) Every place of a part is chosen with the same probability, so that the mean over those that are
///       chosen is without bias; they lie evenly spread over the part.
class SamplePlaces {
  public:
    enum Part { OnStrips, Beside };
    static constexpr std::uint32_t kPlaces = 1024;

    void part(PixelIndex pixel, const WaterRegion& region,
              std::span<const MirroredWires::Strip* const> strips, std::uint64_t key);

    std::size_t count(Part part) const { return places_[part].size(); }
    double share(Part part) const { return static_cast<double>(count(part)) / kPlaces; }

    /// Appends `chosen` of a part's places, pixel-local. Requires: chosen <= count(part).
    void choose(Part part, std::size_t chosen, CounterRandom& random, std::vector<Point>& places) const;

  private:
    std::vector<Point> by_cell_;
    std::vector<Point> places_[2];
};

}  // namespace keikan
