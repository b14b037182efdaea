// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "keikan/model/pixel.hpp"
#include "sample_sums.hpp"

namespace keikan {

/// How much better Sobol's points are than as many independent ones, by part of the picture. The variance of
/// samples tells the error of independent points alone; how much less Sobol's err depends on how smooth the
/// water is, from a tenth of the variance far away to nine tenths where waves break up a reflection.
///
/// It is measured: some pixels of each tile take kBlocks blocks of kBlock points, a block being a randomised
/// net by itself, and the variance of the blocks' means is held against that of the samples, both in codes of
/// 8 bits. A tile with few such pixels leans on the whole picture.
class SobolGain {
  public:
    static constexpr int kTile = 64, kStep = 8;  ///< pixels across a tile; one of kStep x kStep is measured
    static constexpr std::size_t kBlock = 16, kBlocks = 4;

    explicit SobolGain(ImageSize size);

    static bool measures(PixelIndex p) { return p.x % kStep == kStep / 2 && p.y % kStep == kStep / 2; }

    /// What one pixel says.
    struct Note {
        PixelIndex pixel;
        double of_blocks = 0;   ///< kBlock times the variance of the blocks' means
        double of_samples = 0;  ///< variance of the samples
        double mean[3] = {0, 0, 0}, variance[3] = {0, 0, 0};  ///< of the samples, in linear light
    };
    static Note note(PixelIndex pixel, const std::vector<Rgb>& samples);

    /// Takes all notes, in this order.
    void settle(const std::vector<Note>& notes);

    /// The variance of the mean of n of Sobol's points in this part of the picture is n^exponent of that of
    /// as many independent ones: 1 for one point and as measured for kBlock. At most 0.
    double exponent(PixelIndex pixel) const { return exponent_[tile(pixel)]; }

  private:
    std::size_t tile(PixelIndex p) const;
    int columns_;
    std::vector<double> exponent_;  ///< of each tile
};

}  // namespace keikan
