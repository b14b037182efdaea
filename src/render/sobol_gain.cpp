// SPDX-License-Identifier: Apache-2.0
#include "sobol_gain.hpp"

#include <algorithm>
#include <cmath>

#include "keikan/support/check.hpp"

namespace keikan {

namespace {

/// Shares beyond these are noise of the measurement, or so good that nothing depends on it.
constexpr double kLeastShare = 0.02, kMostShare = 1;

/// Pixels that the whole picture counts for, beside a tile's own.
constexpr double kWholePicture = 4;

}  // namespace

SobolGain::SobolGain(ImageSize size) : columns_((size.width + kTile - 1) / kTile) {
    const int rows = (size.height + kTile - 1) / kTile;
    exponent_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows), 0);
}

std::size_t SobolGain::tile(PixelIndex p) const {
    return static_cast<std::size_t>(p.y / kTile) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(p.x / kTile);
}

SobolGain::Note SobolGain::note(PixelIndex pixel, const std::vector<Rgb>& samples) {
    KEIKAN_CHECK(samples.size() == kBlock * kBlocks, samples.size() << " samples");
    SampleSums all, means;
    for (std::size_t block = 0; block < kBlocks; ++block) {
        SampleSums own;
        for (std::size_t i = 0; i < kBlock; ++i) {
            own.add(samples[block * kBlock + i]);
            all.add(samples[block * kBlock + i]);
        }
        means.add(own.mean(0), own.mean(1), own.mean(2));
    }
    Note note{pixel};
    for (int c = 0; c < 3; ++c) {
        const double codes = codes_per_light(all.mean(c));
        note.of_blocks += static_cast<double>(kBlock) * means.variance(c) * codes * codes;
        note.of_samples += all.variance(c) * codes * codes;
        note.mean[c] = all.mean(c);
        note.variance[c] = all.variance(c);
    }
    return note;
}

void SobolGain::settle(const std::vector<Note>& notes) {
    std::vector<double> blocks(exponent_.size(), 0), samples(exponent_.size(), 0),
        pixels(exponent_.size(), 0);
    double all_blocks = 0, all_samples = 0;
    for (const Note& note : notes) {
        const std::size_t t = tile(note.pixel);
        blocks[t] += note.of_blocks;
        samples[t] += note.of_samples;
        pixels[t] += 1;
        all_blocks += note.of_blocks;
        all_samples += note.of_samples;
    }
    const double whole = all_samples > 0 ? all_blocks / all_samples : kMostShare;
    for (std::size_t t = 0; t < exponent_.size(); ++t) {
        const double own = samples[t] > 0 ? blocks[t] / samples[t] : whole;
        const double share = (pixels[t] * own + kWholePicture * whole) / (pixels[t] + kWholePicture);
        exponent_[t] =
            std::log(std::clamp(share, kLeastShare, kMostShare)) / std::log(static_cast<double>(kBlock));
    }
}

}  // namespace keikan
