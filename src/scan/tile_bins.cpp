// SPDX-License-Identifier: Apache-2.0
#include "tile_bins.hpp"

#include <algorithm>

#include "keikan/support/parallel.hpp"

namespace keikan {
namespace {

/// Tiles [first, last] along one axis that the closed interval [low, high] of pixels meets; a border shared
/// by two tiles belongs to both.
struct TileRange {
    int first = 0;
    int last = -1;
};

TileRange tiles_met(double low, double high, int tiles) {
    low /= kTileSize;
    high /= kTileSize;
    if (!(high >= 0 && low <= tiles)) return {};
    // Clamped before the conversion, which then rounds down.
    const double from = std::max(low, 0.0);
    const int first = static_cast<int>(from);
    const int last = static_cast<int>(std::min(high, tiles - 1.0));
    return {first > 0 && first == from ? first - 1 : first, last};
}

/// Faces binned by one call.
constexpr std::size_t kFacesPerRun = 32768;

}  // namespace

TileBins tile_bins(const std::vector<FaceFacts>& facts, ImageSize size) {
    TileBins bins;
    bins.columns = (size.width + kTileSize - 1) / kTileSize;
    bins.rows = (size.height + kTileSize - 1) / kTileSize;
    const std::size_t tiles = static_cast<std::size_t>(bins.columns) * static_cast<std::size_t>(bins.rows);
    const std::size_t runs = (facts.size() + kFacesPerRun - 1) / kFacesPerRun;

    const auto for_each_tile = [&](std::size_t run, const auto& visit) {
        const std::size_t end = std::min(facts.size(), (run + 1) * kFacesPerRun);
        for (std::size_t f = run * kFacesPerRun; f < end; ++f) {
            const TileRange x = tiles_met(facts[f].left, facts[f].right, bins.columns);
            const TileRange y = tiles_met(facts[f].top, facts[f].bottom, bins.rows);
            for (int row = y.first; row <= y.last; ++row)
                for (int column = x.first; column <= x.last; ++column)
                    visit(f, static_cast<std::size_t>(row) * static_cast<std::size_t>(bins.columns) +
                                 static_cast<std::size_t>(column));
        }
    };

    // Count, then fill. Each run of faces has its own counters, which become its own places to write to:
    // runs share nothing, and every tile's list rises, whoever fills it.
    std::vector<std::vector<std::uint32_t>> places(runs);
    parallel_for(runs, [&](std::size_t run) {
        places[run].assign(tiles, 0);
        for_each_tile(run, [&](std::size_t, std::size_t tile) { ++places[run][tile]; });
    });
    bins.begin.resize(tiles + 1);
    std::uint32_t total = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        bins.begin[tile] = total;
        for (std::vector<std::uint32_t>& place : places) {
            const std::uint32_t count = place[tile];
            place[tile] = total;
            total += count;
        }
    }
    bins.begin[tiles] = total;
    bins.faces.resize(total);
    parallel_for(runs, [&](std::size_t run) {
        for_each_tile(run, [&](std::size_t f, std::size_t tile) {
            bins.faces[places[run][tile]++] = static_cast<std::uint32_t>(f);
        });
    });
    return bins;
}

}  // namespace keikan
