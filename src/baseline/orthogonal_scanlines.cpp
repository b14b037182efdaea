// SPDX-License-Identifier: Apache-2.0
#include "keikan/baseline/orthogonal_scanlines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "band_assembly.hpp"
#include "keikan/support/check.hpp"
#include "row_shares.hpp"
#include "scanline_sweep.hpp"

namespace keikan::baseline {

namespace {

/// What the level lines of one row have found.
struct LevelRow {
    explicit LevelRow(int width)
        : shares(width), borders(static_cast<std::size_t>(width)), corners(static_cast<std::size_t>(width)) {}

    RowShares shares;
    std::vector<double> borders;                      ///< met by level lines in each pixel
    std::vector<std::vector<std::uint32_t>> corners;  ///< faces with a vertex in the pixel
    std::vector<WaterPoint> water;

    void clear() {
        shares.clear();
        std::fill(borders.begin(), borders.end(), 0.0);
        for (auto& faces : corners) faces.clear();
        water.clear();
    }
};

class OrthogonalScanlines {
  public:
    OrthogonalScanlines(const FacesInView& view, int lines)
        : view_(view),
          width_(view.camera().size.width),
          lines_(lines),
          sweep_(view.faces()),
          level_(width_),
          builder_(view.faces().size()) {}

    void operator()(BandRows rows, ScanBand& band, std::vector<WaterPoint>& water) {
        builder_.begin(rows.first, rows.count);
        const auto faces = view_.of_band(rows.first);
        sort_corners(faces, rows);
        const Scanlines lines{std::int64_t{rows.first} * lines_, 0, lines_, rows.count * lines_ + 1};
        level_.clear();
        sweep_(faces, lines, width_, [&](int k, std::span<const Stretch> seen) {
            const int row = k / lines_;
            if (k % lines_ != 0) return take(seen, rows.first + row, k % lines_, 1);
            if (row > 0) {  // the lower border of the row above
                take(seen, rows.first + row - 1, lines_, 0.5);
                finish_row(rows.first + row - 1, row - 1, water);
                level_.clear();
            }
            if (row < rows.count) take(seen, rows.first + row, 0, 0.5);
        });
        finish_band(builder_, view_, band);
    }

  private:
    /// Vertices of the band's faces, by row.
    void sort_corners(std::span<const std::uint32_t> faces, BandRows rows) {
        corners_.clear();
        for (const std::uint32_t f : faces)
            for (const Point p : view_.faces()[f].outline) {
                const int y = static_cast<int>(std::floor(p.y));
                if (p.x >= 0 && p.x < width_ && y >= rows.first && y < rows.first + rows.count)
                    corners_.push_back({static_cast<int>(p.x), y, f});
            }
        std::stable_sort(corners_.begin(), corners_.end(),
                         [](const Corner& a, const Corner& b) { return a.y < b.y; });
    }

    void take(std::span<const Stretch> seen, int y, int line, double weight) {
        const double height = static_cast<double>(line) / lines_;
        level_.shares.add(seen, height, weight);
        double end_before = 0;
        for (const Stretch& s : seen) {
            if (s.begin > end_before) count_border(end_before, weight);
            count_border(s.begin, weight);
            end_before = s.end;
        }
        count_border(end_before, weight);
        // The lower border belongs to the row above here.
        look_at_water(seen, std::min(y + height, std::nextafter(y + 1.0, 0.0)), weight, view_, level_.water);
    }

    void count_border(double x, double weight) {
        const double column = std::floor(x);
        if (x > column && x < width_ && x > 0) level_.borders[static_cast<std::size_t>(column)] += weight;
    }

    void finish_row(int y, int row, std::vector<WaterPoint>& water) {
        const auto first = std::partition_point(corners_.begin(), corners_.end(),
                                                [&](const Corner& corner) { return corner.y < y; });
        for (auto corner = first; corner != corners_.end() && corner->y == y; ++corner)
            level_.corners[static_cast<std::size_t>(corner->x)].push_back(corner->face);
        for (int x = 0; x < width_; ++x) finish_pixel({x, y}, row);
        finish_water(water);
    }

    void finish_pixel(PixelIndex pixel, int row) {
        const auto x = static_cast<std::size_t>(pixel.x);
        const auto level = level_.shares.at(pixel.x);
        const auto& corners = level_.corners[x];
        double covered = 0;
        for (const Share& share : level) covered += share.weight;
        const double nothing = kShareRounding * lines_;
        const bool plain = level.empty() || (level.size() == 1 && covered >= lines_ - nothing);
        if (plain && corners.empty()) return put_pixel(builder_, row, pixel.x, level, lines_, parts_);
        look_upright(pixel, level, corners);
        const double both = level_.borders[x] + upright_borders_;
        const double by_level = both > 0 ? level_.borders[x] / both : 1;
        mixed_.clear();
        for (const Share& s : level) mix(s, by_level);
        for (const Share& s : upright_) mix(s, 1 - by_level);
        put_pixel(builder_, row, pixel.x, mixed_, lines_, parts_);
        for (WaterPoint& point : water_in(pixel.x)) rescale(point, level);
    }

    void mix(const Share& share, double by) {
        if (by > 0 && share.weight > 0)
            add_share(mixed_, share.face, by * share.weight, share.x / share.weight, share.y / share.weight);
    }

    /// What the upright lines see of the faces that are known in the pixel.
    void look_upright(PixelIndex pixel, std::span<const Share> level,
                      std::span<const std::uint32_t> corners) {
        known_.clear();
        for (const Share& share : level) known_.push_back(share.face);
        known_.insert(known_.end(), corners.begin(), corners.end());
        std::sort(known_.begin(), known_.end());
        known_.erase(std::unique(known_.begin(), known_.end()), known_.end());
        upright_.clear();
        upright_borders_ = 0;
        for (int k = 0; k < lines_; ++k) {
            const double at = (k + 0.5) / lines_;
            crossed_.clear();
            for (const std::uint32_t f : known_) cross(f, pixel, pixel.x + at);
            std::sort(crossed_.begin(), crossed_.end(),
                      [](const Crossed& a, const Crossed& b) { return a.begin < b.begin; });
            double end_before = 0;
            for (const Stretch& s : visible_(crossed_, 1)) {
                add_share(upright_, s.face, s.end - s.begin, at, (s.begin + s.end) / 2);
                upright_borders_ += (s.begin > end_before && end_before > 0) + (s.begin > 0);
                end_before = s.end;
            }
            upright_borders_ += end_before > 0 && end_before < 1;
        }
    }

    /// Where the upright line at x crosses the face, from the pixel's upper border on.
    void cross(std::uint32_t f, PixelIndex pixel, double x) {
        const FaceView face = view_.faces()[f];
        double begin = std::numeric_limits<double>::infinity(), end = -begin;
        Point p = face.outline.back();
        for (const Point q : face.outline) {
            const Point &left = p.x < q.x ? p : q, &right = p.x < q.x ? q : p;
            if (left.x <= x && x < right.x) {
                const double y = left.y + (x - left.x) / (right.x - left.x) * (right.y - left.y) - pixel.y;
                begin = std::min(begin, y);
                end = std::max(end, y);
            }
            p = q;
        }
        if (!(begin < 1 && end > 0)) return;
        crossed_.push_back(
            {begin, end, face.depth.b, face.depth.a * x + face.depth.b * pixel.y + face.depth.c, f});
    }

    /// The points of the row's pixel; they come line by line, so they are put in order once a row.
    std::span<WaterPoint> water_in(int x) {
        if (level_.water.empty()) return {};
        if (!water_sorted_) {
            std::stable_sort(level_.water.begin(), level_.water.end(),
                             [](const WaterPoint& p, const WaterPoint& q) { return p.x < q.x; });
            water_sorted_ = true;
        }
        const auto first = std::partition_point(level_.water.begin(), level_.water.end(),
                                                [&](const WaterPoint& p) { return p.x < x; });
        const auto end =
            std::partition_point(first, level_.water.end(), [&](const WaterPoint& p) { return p.x == x; });
        return {first, end};
    }

    /// From what the level lines give to its object to what both directions give.
    void rescale(WaterPoint& point, std::span<const Share> level) const {
        const auto weight_of_object = [&](std::span<const Share> shares) {
            double sum = 0;
            for (const Share& s : shares)
                if (view_.object(s.face) == point.object) sum += s.weight;
            return sum;
        };
        const double by_level = weight_of_object(level);
        if (by_level > 0) point.weight *= weight_of_object(mixed_) / by_level;
    }

    void finish_water(std::vector<WaterPoint>& water) {
        for (WaterPoint point : level_.water) {
            point.weight /= lines_;
            water.push_back(point);
        }
        water_sorted_ = false;
    }

    struct Corner {
        int x = 0, y = 0;
        std::uint32_t face = 0;
    };

    const FacesInView& view_;
    int width_;
    int lines_;
    ScanlineSweep sweep_;
    LevelRow level_;
    bool water_sorted_ = false;
    VisibleStretches visible_;
    BandBuilder builder_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> known_;
    std::vector<Crossed> crossed_;
    std::vector<Share> upright_, mixed_;
    double upright_borders_ = 0;
    std::vector<SeenPart> parts_;
};

}  // namespace

std::function<BandMaker()> orthogonal_scanlines(const FacesInView& view, int lines) {
    KEIKAN_CHECK(lines >= 1, "orthogonal scanlines with " << lines << " lines");
    return makers_of<OrthogonalScanlines>(std::cref(view), lines);
}

}  // namespace keikan::baseline
