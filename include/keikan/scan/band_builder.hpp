// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// Puts a band together from what is found in its pixels. Each row is filled from the left to the right; the
/// rows in any order. Faces are given by their position among the projected faces, and numbered anew within
/// the band as they come. One object a thread.
class BandBuilder {
  public:
    static constexpr std::uint32_t kBackground = Span::kBackground;

    /// `faces`: how many projected faces there are.
    explicit BandBuilder(std::size_t faces) : band_index_(faces, kUnseen) {}

    void begin(int first_row, int rows);
    /// Pixels [x_begin, x_end) of row `row` of the band show `face` only, or kBackground.
    void add_span(int row, int x_begin, int x_end, std::uint32_t face);
    /// A divided pixel. `parts` name projected faces.
    void add_divided(int row, int x, Division division, std::span<const SeenPart> parts, double background);

    /// Projected faces seen in the band, in the order of their numbers.
    std::span<const std::uint32_t> seen() const { return seen_; }
    /// The band so far, into `band`; `band.faces` is left to the caller. Ready for `begin` again.
    void finish(ScanBand& band);

  private:
    std::uint32_t band_index(std::uint32_t face) {
        if (band_index_[face] == kUnseen) {
            band_index_[face] = static_cast<std::uint32_t>(seen_.size());
            seen_.push_back(face);
        }
        return band_index_[face];
    }

    static constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();
    int first_row_ = 0, rows_ = 0;
    std::vector<std::uint32_t> band_index_;
    std::vector<std::uint32_t> seen_;
    std::vector<SeenPart> parts_;                     ///< in the order of arrival
    std::vector<std::vector<Span>> spans_;            ///< of each row
    std::vector<std::vector<DividedPixel>> divided_;  ///< of each row
};

}  // namespace keikan
