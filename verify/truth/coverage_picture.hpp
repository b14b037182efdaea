// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "keikan/model/pixel.hpp"

namespace keikan::truth {

/// How much of a pixel one matte covers: the exact fraction, rounded once.
struct Share {
    static constexpr std::uint32_t kBackground = 0xFFFFFFFFu;
    std::uint32_t matte = 0;  ///< into CoveragePicture::mattes, or kBackground
    float coverage = 0;       ///< nearest float
    std::uint16_t code = 0;   ///< nearest of 0 ... 65535, of 65535 times the exact fraction
    friend bool operator==(const Share&, const Share&) = default;
};

/// Ground truth: the exact visible coverage of every pixel by every matte (an object, or a layer), each value
/// rounded once and correctly. Only what is seen is kept.
struct CoveragePicture {
    ImageSize size;
    std::vector<std::string> mattes;  ///< names, each once
    std::vector<Share> shares;        ///< pixel by pixel from the top left; by rising matte, background last
    std::vector<std::size_t> begin;   ///< pixels + 1 values, into `shares`

    std::span<const Share> at(int x, int y) const {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
        return std::span(shares).subspan(begin[pixel], begin[pixel + 1] - begin[pixel]);
    }

    /// Appends the next pixel.
    void add_pixel(std::span<const Share> seen) {
        if (begin.empty()) begin.push_back(0);
        shares.insert(shares.end(), seen.begin(), seen.end());
        begin.push_back(shares.size());
    }
};

}  // namespace keikan::truth
