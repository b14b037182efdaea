// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "keikan/model/pixel.hpp"
#include "sobol_gain.hpp"

namespace keikan {

/// The variance of single samples near a pixel, from the pixels that were measured beforehand: what a pixel's
/// own first samples, being few, are held together with, so that they may be few and do not mislead.
class NearVariance {
  public:
    explicit NearVariance(ImageSize size);

    void settle(const std::vector<SobolGain::Note>& notes);

    /// Of single samples, in linear light.
    struct Channel {
        double mean = 0, variance = 0;
    };
    /// Red, green, blue: between the up to four measured pixels around this one, by their distances. Nothing
    /// where none of them was measured.
    std::optional<std::array<Channel, 3>> at(PixelIndex pixel) const;

  private:
    /// Place in the lattice of measured pixels; the first is 0.
    static int cell(int coordinate) { return coordinate / SobolGain::kStep; }

    int columns_, rows_;
    struct Cell {
        std::array<float, 3> mean{}, variance{};
        bool measured = false;
    };
    std::vector<Cell> cells_;
};

}  // namespace keikan
