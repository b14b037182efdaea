// SPDX-License-Identifier: Apache-2.0
#include "near_variance.hpp"

#include <algorithm>

namespace keikan {

NearVariance::NearVariance(ImageSize size)
    : columns_(cell(size.width) + 1),
      rows_(cell(size.height) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void NearVariance::settle(const std::vector<SobolGain::Note>& notes) {
    for (const SobolGain::Note& note : notes) {
        Cell& at = cells_[static_cast<std::size_t>(cell(note.pixel.y) * columns_ + cell(note.pixel.x))];
        for (std::size_t c = 0; c < 3; ++c) {
            at.mean[c] = static_cast<float>(note.mean[c]);
            at.variance[c] = static_cast<float>(note.variance[c]);
        }
        at.measured = true;
    }
}

std::optional<std::array<NearVariance::Channel, 3>> NearVariance::at(PixelIndex pixel) const {
    constexpr int kStep = SobolGain::kStep;
    // The lattice's pixels are in the middle of their cells.
    const int x = pixel.x - kStep / 2, y = pixel.y - kStep / 2;
    const int left = x < 0 ? -1 : x / kStep, above = y < 0 ? -1 : y / kStep;
    const double u = static_cast<double>(x - left * kStep) / kStep,
                 v = static_cast<double>(y - above * kStep) / kStep;
    std::array<Channel, 3> sum{};
    double weights = 0;
    for (const int down : {0, 1})
        for (const int right : {0, 1}) {
            const int column = left + right, row = above + down;
            if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
            const Cell& measured = cells_[static_cast<std::size_t>(row * columns_ + column)];
            const double weight = (right == 1 ? u : 1 - u) * (down == 1 ? v : 1 - v);
            if (!measured.measured || !(weight > 0)) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c].mean += weight * static_cast<double>(measured.mean[c]);
                sum[c].variance += weight * static_cast<double>(measured.variance[c]);
            }
            weights += weight;
        }
    if (!(weights > 0)) return std::nullopt;
    for (Channel& channel : sum) {
        channel.mean /= weights;
        channel.variance /= weights;
    }
    return sum;
}

}  // namespace keikan
