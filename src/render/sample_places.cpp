// SPDX-License-Identifier: Apache-2.0
#include "sample_places.hpp"

#include <algorithm>

#include "keikan/support/check.hpp"
#include "keikan/wave/pixel_sampler.hpp"

namespace keikan {

namespace {

/// The bits of v, each second one from now on.
std::uint32_t spread_bits(std::uint32_t v) {
    std::uint32_t spread = 0;
    for (int bit = 0; bit < 8; ++bit) spread |= (v >> bit & 1u) << (2 * bit);
    return spread;
}

}  // namespace

void SamplePlaces::part(PixelIndex pixel, const WaterRegion& region,
                        std::span<const MirroredWires::Strip* const> strips, std::uint64_t key) {
    // One of the points is in each of 32 x 32 cells: in the order of Z over these, neighbours are near each
    // other.
    constexpr std::uint32_t kCells = 32;
    static_assert(kCells * kCells == kPlaces);
    by_cell_.resize(kPlaces);
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
        const Point u = scrambled_sobol(i, key);
        const auto cell = [](double at) { return static_cast<std::uint32_t>(at * kCells); };
        by_cell_[spread_bits(cell(u.x)) | spread_bits(cell(u.y)) << 1] = u;
    }
    places_[OnStrips].clear();
    places_[Beside].clear();
    for (const Point u : by_cell_) {
        const Point local = region.at(u), p{pixel.x + local.x, pixel.y + local.y};
        const bool on = std::any_of(strips.begin(), strips.end(),
                                    [&](const MirroredWires::Strip* strip) { return strip->holds(p); });
        places_[on ? OnStrips : Beside].push_back(local);
    }
}

void SamplePlaces::choose(Part part, std::size_t chosen, CounterRandom& random,
                          std::vector<Point>& places) const {
    const std::size_t all = count(part);
    KEIKAN_CHECK(chosen <= all, chosen << " of " << all << " places");
    // Steps of equal length from a random start: each place is met with probability chosen / all.
    const double step = static_cast<double>(all) / static_cast<double>(chosen), start = random.uniform();
    for (std::size_t i = 0; i < chosen; ++i) {
        const auto at = static_cast<std::size_t>((static_cast<double>(i) + start) * step);
        places.push_back(places_[part][std::min(at, all - 1)]);
    }
}

}  // namespace keikan
