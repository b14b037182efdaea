// SPDX-License-Identifier: Apache-2.0
#include "keikan/baseline/supersampling.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "band_assembly.hpp"
#include "keikan/support/check.hpp"
#include "keikan/wave/counter_random.hpp"
#include "packet_rays.hpp"
#include "row_shares.hpp"

namespace keikan::baseline {

namespace {

constexpr std::uint32_t kPlaceInCell = 11;  ///< what the random numbers are for

class Supersampling {
  public:
    Supersampling(const FacesInView& view, std::shared_ptr<const SupersamplingOptions> options,
                  std::shared_ptr<const PacketRays> rays)
        : view_(view),
          kept_(std::move(options)),
          options_(*kept_),
          cells_(sample_cells(options_.samples)),
          rays_(std::move(rays)),
          size_(view.camera().size),
          builder_(view.faces().size()) {}

    void operator()(BandRows rows, ScanBand& band, std::vector<WaterPoint>& water) {
        builder_.begin(rows.first, rows.count);
        for (int row = 0; row < rows.count; row += kPacketRows)
            for (int x = 0; x < size_.width; x += kPacketColumns) {
                const int y = rows.first + row;
                look(x, y, water);
                for (std::size_t lane = 0; lane < kPacket; ++lane) {
                    const PixelIndex pixel = pixel_of_lane({x, y}, lane);
                    if (inside(pixel))
                        put_pixel(builder_, pixel.y - rows.first, pixel.x, shares_[lane], options_.samples,
                                  parts_);
                }
            }
        finish_band(builder_, view_, band);
    }

  private:
    bool inside(PixelIndex pixel) const { return pixel.x < size_.width && pixel.y < size_.height; }
    bool wanted(PixelIndex pixel) const {
        return inside(pixel) && (options_.only.width() == 0 || options_.only[pixel] != 0);
    }

    /// All samples of a packet's pixels.
    void look(int x, int y, std::vector<WaterPoint>& water) {
        std::array<bool, kPacket> lanes{};
        std::array<std::uint64_t, kPacket> keys{};
        bool any = false;
        for (std::size_t lane = 0; lane < kPacket; ++lane) {
            const PixelIndex pixel = pixel_of_lane({x, y}, lane);
            shares_[lane].clear();
            lanes[lane] = wanted(pixel);
            any |= lanes[lane];
            if (options_.pattern == SamplePattern::Random)
                keys[lane] = random_key(pixel.x, pixel.y, kPlaceInCell, options_.seed);
        }
        if (!any) return;
        PacketPlaces places;
        PacketHits hits;
        std::uint64_t sample = 0;
        for (int j = 0; j < cells_.rows; ++j)
            for (int i = 0; i < cells_.columns; ++i, ++sample) {
                for (std::size_t lane = 0; lane < kPacket; ++lane)
                    places[lane] = place(i, j, CounterRandom(keys[lane], 2 * sample));
                rays_->meet({x, y}, places, lanes, hits);
                for (std::size_t lane = 0; lane < kPacket; ++lane)
                    if (lanes[lane] && hits[lane] != kNoFace)
                        take(pixel_of_lane({x, y}, lane), lane, hits[lane], places[lane], water);
            }
    }

    Point place(int i, int j, CounterRandom random) const {
        double u = 0.5, v = 0.5;
        if (options_.pattern == SamplePattern::Random) u = random.uniform(), v = random.uniform();
        return {(i + u) / cells_.columns, (j + v) / cells_.rows};
    }

    void take(PixelIndex pixel, std::size_t lane, std::uint32_t face, Point at,
              std::vector<WaterPoint>& water) {
        add_share(shares_[lane], face, 1, at.x, at.y);
        if (view_.is_water(face))
            water.push_back({pixel.x, pixel.y, view_.object(face), at, 1.0 / options_.samples});
    }

    const FacesInView& view_;
    std::shared_ptr<const SupersamplingOptions> kept_;
    const SupersamplingOptions& options_;
    SampleCells cells_;
    std::shared_ptr<const PacketRays> rays_;
    ImageSize size_;
    BandBuilder builder_;
    std::array<std::vector<Share>, kPacket> shares_;
    std::vector<SeenPart> parts_;
};

}  // namespace

SampleCells sample_cells(int samples) {
    int rows = static_cast<int>(std::sqrt(static_cast<double>(samples)));
    while (rows * rows < samples || samples % rows != 0) ++rows;
    return {samples / rows, rows};
}

std::function<BandMaker()> supersampling(const FacesInView& view, const SupersamplingOptions& options) {
    KEIKAN_CHECK(options.samples >= 1, "supersampling with " << options.samples << " samples");
    const auto rays = std::make_shared<const PacketRays>(view);
    const auto kept = std::make_shared<const SupersamplingOptions>(options);
    return makers_of<Supersampling>(std::cref(view), kept, rays);
}

}  // namespace keikan::baseline
