// SPDX-License-Identifier: Apache-2.0
#include "keikan/baseline/multi_scanning.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "band_assembly.hpp"
#include "keikan/support/check.hpp"
#include "row_shares.hpp"
#include "scanline_sweep.hpp"

namespace keikan::baseline {

namespace {

/// Of the pixels of a row, the first whose centre is at or right of x.
int first_centre_from(double x, int width) {
    return x < 0.5 ? 0 : std::min(static_cast<int>(std::ceil(x - 0.5)), width);
}

class PointSampling {
  public:
    explicit PointSampling(const FacesInView& view)
        : view_(view),
          width_(view.camera().size.width),
          sweep_(view.faces()),
          builder_(view.faces().size()) {}

    void operator()(BandRows rows, ScanBand& band, std::vector<WaterPoint>& water) {
        builder_.begin(rows.first, rows.count);
        sweep_(view_.of_band(rows.first), {rows.first, 0.5, 1, rows.count}, width_,
               [&](int row, std::span<const Stretch> seen) { take(row, rows.first + row, seen, water); });
        finish_band(builder_, view_, band);
    }

  private:
    void take(int row, int y, std::span<const Stretch> seen, std::vector<WaterPoint>& water) {
        int done = 0;
        const auto span_to = [&](int end, std::uint32_t face) {
            if (end > done) builder_.add_span(row, done, end, face);
            done = std::max(done, end);
        };
        for (const Stretch& s : seen) {
            span_to(first_centre_from(s.begin, width_), BandBuilder::kBackground);
            const int first = done, end = first_centre_from(s.end, width_);
            span_to(end, s.face);
            if (!view_.is_water(s.face)) continue;
            for (int x = first; x < end; ++x) water.push_back({x, y, view_.object(s.face), {0.5, 0.5}, 1});
        }
        span_to(width_, BandBuilder::kBackground);
    }

    const FacesInView& view_;
    int width_;
    ScanlineSweep sweep_;
    BandBuilder builder_;
};

class MultiScanning {
  public:
    MultiScanning(const FacesInView& view, int lines)
        : view_(view),
          width_(view.camera().size.width),
          lines_(lines),
          sweep_(view.faces()),
          shares_(width_),
          builder_(view.faces().size()) {}

    void operator()(BandRows rows, ScanBand& band, std::vector<WaterPoint>& water) {
        builder_.begin(rows.first, rows.count);
        const Scanlines lines{std::int64_t{rows.first} * lines_, 0.5, lines_, rows.count * lines_};
        sweep_(view_.of_band(rows.first), lines, width_, [&](int k, std::span<const Stretch> seen) {
            const int in_row = k % lines_, row = k / lines_;
            const double y = (in_row + 0.5) / lines_;
            shares_.add(seen, y, 1);
            look_at_water(seen, rows.first + row + y, 1.0 / lines_, view_, water);
            if (in_row + 1 == lines_) finish_row(row);
        });
        finish_band(builder_, view_, band);
    }

  private:
    void finish_row(int row) {
        for (int x = 0; x < width_; ++x) put_pixel(builder_, row, x, shares_.at(x), lines_, parts_);
        shares_.clear();
    }

    const FacesInView& view_;
    int width_;
    int lines_;
    ScanlineSweep sweep_;
    RowShares shares_;
    BandBuilder builder_;
    std::vector<SeenPart> parts_;
};

}  // namespace

std::function<BandMaker()> point_sampling(const FacesInView& view) {
    return makers_of<PointSampling>(std::cref(view));
}

std::function<BandMaker()> multi_scanning(const FacesInView& view, int lines) {
    KEIKAN_CHECK(lines >= 1, "multi-scanning with " << lines << " lines");
    return makers_of<MultiScanning>(std::cref(view), lines);
}

}  // namespace keikan::baseline
