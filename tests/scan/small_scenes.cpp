// SPDX-License-Identifier: Apache-2.0
#include "small_scenes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace keikan::small_scenes {

std::vector<ScanBand> scanned(const Geometry& geometry, const Camera& camera, const ScanOptions& options) {
    std::vector<ScanBand> bands;
    scan_faces(project_faces(geometry, camera), geometry, camera, options,
               [&](const ScanBand& band) { bands.push_back(band); });
    return bands;
}

std::vector<Shown> shown(const std::vector<ScanBand>& bands, ImageSize size) {
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    std::vector<Shown> all(pixels);
    std::vector<int> times(pixels, 0);
    const auto pixel = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    };
    for (const ScanBand& band : bands)
        for (int row = 0; row < band.rows; ++row) {
            const int y = band.first_row + row;
            const auto r = static_cast<std::size_t>(row);
            for (std::uint32_t s = band.span_begin[r]; s < band.span_begin[r + 1]; ++s)
                for (int x = band.spans[s].x_begin; x < band.spans[s].x_end; ++x) {
                    ++times[pixel(x, y)];
                    Shown& one = all[pixel(x, y)];
                    if (band.spans[s].face == Span::kBackground)
                        one.background = 1;
                    else
                        one.weights = {{band.faces[band.spans[s].face].id, 1.0}};
                }
            for (std::uint32_t d = band.divided_begin[r]; d < band.divided_begin[r + 1]; ++d) {
                const DividedPixel& divided = band.divided[d];
                ++times[pixel(divided.x, y)];
                Shown& one = all[pixel(divided.x, y)];
                one.divided = true;
                one.division = divided.division;
                one.background = divided.background;
                for (std::uint32_t p = divided.part_begin; p < divided.part_end; ++p)
                    one.weights.emplace_back(band.faces[band.parts[p].face].id, band.parts[p].weight);
                std::sort(one.weights.begin(), one.weights.end());
            }
        }
    REQUIRE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    return all;
}

}  // namespace keikan::small_scenes
