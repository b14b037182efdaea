// SPDX-License-Identifier: Apache-2.0
#include "keikan/baseline/catmull.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "band_assembly.hpp"
#include "keikan/clip/visible_areas.hpp"

namespace keikan::baseline {

namespace {

/// Added to a face's extent in a row: far more than the rounding of a crossing (2^-52 of an outline's extent
/// of a million pixels), far less than a pixel. A face that is asked about in vain shows nothing.
constexpr double kExtentMargin = 0x1p-20;

/// A face and the pixels of one row that it may meet.
struct Reach {
    std::uint32_t face = 0;
    int first = 0;
    int last = 0;
};

struct Extent {
    double left = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    void add(double x) {
        left = std::min(left, x);
        right = std::max(right, x);
    }
};

/// From where to where an outline reaches between the heights `top` and `bottom`.
Extent extent_between(std::span<const Point> outline, double top, double bottom) {
    Extent extent;
    Point p = outline.back();
    for (const Point q : outline) {
        if (q.y >= top && q.y <= bottom) extent.add(q.x);
        for (const double y : {top, bottom})
            if ((p.y < y) != (q.y < y)) extent.add(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
        p = q;
    }
    return extent;
}

class ExactEverywhere {
  public:
    explicit ExactEverywhere(const FacesInView& view)
        : view_(view),
          width_(view.camera().size.width),
          builder_(view.faces().size()),
          begin_(static_cast<std::size_t>(width_) + 1) {}

    void operator()(BandRows rows, ScanBand& band, std::vector<WaterPoint>& water) {
        builder_.begin(rows.first, rows.count);
        for (int row = 0; row < rows.count; ++row) {
            sort_into_pixels(view_.of_band(rows.first), rows.first + row);
            for (int x = 0; x < width_; ++x) divide({x, rows.first + row}, row, water);
        }
        finish_band(builder_, view_, band);
    }

  private:
    void sort_into_pixels(std::span<const std::uint32_t> faces, int y) {
        reaches_.clear();
        std::fill(begin_.begin(), begin_.end(), 0u);
        for (const std::uint32_t f : faces) {
            const Extent extent = extent_between(view_.faces()[f].outline, y, y + 1);
            const double left = extent.left - kExtentMargin, right = extent.right + kExtentMargin;
            if (!(left < width_ && right > 0)) continue;
            const int first = static_cast<int>(std::max(left, 0.0));
            const int last = static_cast<int>(std::min(right, width_ - 1.0));
            reaches_.push_back({f, first, last});
            for (int x = first; x <= last; ++x) ++begin_[static_cast<std::size_t>(x) + 1];
        }
        for (std::size_t x = 0; x + 1 < begin_.size(); ++x) begin_[x + 1] += begin_[x];
        place_.assign(begin_.begin(), begin_.end() - 1);
        in_pixel_.resize(begin_.back());
        for (const Reach& reach : reaches_)
            for (int x = reach.first; x <= reach.last; ++x)
                in_pixel_[place_[static_cast<std::size_t>(x)]++] = reach.face;
    }

    void divide(PixelIndex pixel, int row, std::vector<WaterPoint>& water) {
        const auto x = static_cast<std::size_t>(pixel.x);
        const auto here = std::span(in_pixel_).subspan(begin_[x], begin_[x + 1] - begin_[x]);
        if (here.empty()) return builder_.add_span(row, pixel.x, pixel.x + 1, BandBuilder::kBackground);
        asked_.clear();
        for (const std::uint32_t f : here) asked_.push_back(view_.faces()[f]);
        const PixelCoverage seen = visible_areas_(pixel, asked_, Nearness::ByDepth);
        for (const VisiblePart& part : seen.parts)
            if (view_.is_water(here[part.face])) look_at(pixel, here[part.face], part, water);
        if (seen.parts.empty()) return builder_.add_span(row, pixel.x, pixel.x + 1, BandBuilder::kBackground);
        if (seen.parts.size() == 1 && seen.background <= kVisibleAreaError &&
            seen.parts[0].area >= 1 - kVisibleAreaError)
            return builder_.add_span(row, pixel.x, pixel.x + 1, here[seen.parts[0].face]);
        parts_.clear();
        const auto within = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
        for (const VisiblePart& part : seen.parts)
            parts_.push_back({here[part.face], within(part.centroid.x), within(part.centroid.y), part.area});
        builder_.add_divided(row, pixel.x, Division::ExactAreas, parts_, seen.background);
    }

    /// One look at each water object in the pixel, in the middle of its parts.
    void look_at(PixelIndex pixel, std::uint32_t face, const VisiblePart& part,
                 std::vector<WaterPoint>& water) {
        const std::uint16_t object = view_.object(face);
        for (auto point = water.rbegin(); point != water.rend(); ++point) {
            if (point->x != pixel.x || point->y != pixel.y) break;
            if (point->object != object) continue;
            const double share = part.area / (point->weight + part.area);
            point->at.x += share * (part.centroid.x - point->at.x);
            point->at.y += share * (part.centroid.y - point->at.y);
            point->weight += part.area;
            return;
        }
        water.push_back({pixel.x, pixel.y, object, part.centroid, part.area});
    }

    const FacesInView& view_;
    int width_;
    VisibleAreas visible_areas_;
    BandBuilder builder_;
    std::vector<Reach> reaches_;
    std::vector<std::uint32_t> begin_;  ///< width + 1 values, into in_pixel_
    std::vector<std::uint32_t> place_;
    std::vector<std::uint32_t> in_pixel_;  ///< faces of each pixel of the row, rising
    std::vector<FaceView> asked_;
    std::vector<SeenPart> parts_;
};

}  // namespace

std::function<BandMaker()> exact_everywhere(const FacesInView& view) {
    return makers_of<ExactEverywhere>(std::cref(view));
}

}  // namespace keikan::baseline
