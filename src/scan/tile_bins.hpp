// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "face_facts.hpp"
#include "keikan/model/pixel.hpp"

namespace keikan {

/// Side of a tile in pixels; a row of tiles is a band of the scan.
inline constexpr int kTileSize = 16;

/// The picture in square tiles, and for each the faces whose bounding box meets it, in rising order.
struct TileBins {
    int columns = 0;
    int rows = 0;
    std::vector<std::uint32_t> begin;  ///< columns * rows + 1 values, into `faces`
    std::vector<std::uint32_t> faces;

    std::span<const std::uint32_t> tile(int column, int row) const {
        const auto t = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(column);
        return std::span(faces).subspan(begin[t], begin[t + 1] - begin[t]);
    }
};

TileBins tile_bins(const std::vector<FaceFacts>& facts, ImageSize size);

}  // namespace keikan
