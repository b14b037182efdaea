// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "keikan/scan/band_builder.hpp"
#include "visible_stretches.hpp"

namespace keikan::baseline {

/// What was found of one face in one pixel: how much, and the sums of its places, each times its weight.
struct Share {
    std::uint32_t face = 0;
    double weight = 0;
    double x = 0;  ///< pixel-local
    double y = 0;

    void add(double more, double at_x, double at_y) {
        weight += more;
        x += more * at_x;
        y += more * at_y;
    }
};

/// Adds a face's part to the one it has in `shares`, or a new one. Neighbouring lines and samples find the
/// same faces, so the last one is looked at first.
void add_share(std::vector<Share>& shares, std::uint32_t face, double weight, double x, double y);

/// Hands a pixel whose whole weight is `total` to the band: a span where one face has all of it.
void put_pixel(BandBuilder& builder, int row, int x, std::span<const Share> shares, double total,
               std::vector<SeenPart>& parts);

/// What a pixel's weights may lack of its whole by rounding, as a share of it: each of at most 2^23 additions
/// (kMostSamples lines, eight stretches in the pixel) rounds by at most 2^-53 of the sum.
inline constexpr double kShareRounding = 0x1p-30;

/// What the lines of one row of pixels have found.
class RowShares {
  public:
    explicit RowShares(int width) : pixels_(static_cast<std::size_t>(width)) {}

    /// Adds what is seen along a horizontal line at the local height y, as `weight` of the row.
    void add(std::span<const Stretch> stretches, double y, double weight);
    std::span<const Share> at(int x) const { return pixels_[static_cast<std::size_t>(x)]; }
    void clear();

  private:
    std::vector<std::vector<Share>> pixels_;
};

}  // namespace keikan::baseline
