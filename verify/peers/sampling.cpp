// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "keikan/support/check.hpp"
#include "peers/repeated_differences.hpp"

namespace keikan::peers {
namespace {

/// Sample points at the middles of side x side cells. A row of samples is a word of bits, as coverage masks
/// are in rasterizers: a face covers the run of samples between the two points where its outline crosses the
/// row.
class Sampling {
  public:
    explicit Sampling(int side) : side_(side) {}

    void operator()(const PreparedPixel& pixel, Answer& answer) const {
        answer.areas.assign(pixel.in_pixel.size(), 0.0);
        const double share = 1.0 / (side_ * side_);
        int free_samples = 0;
        for (int row = 0; row < side_; ++row) {
            std::uint64_t free = bits_below(side_);
            for (std::size_t i = 0; i < pixel.in_pixel.size() && free != 0; ++i) {
                const std::uint64_t seen = free & samples_in(pixel.in_pixel[i], (row + 0.5) / side_);
                answer.areas[i] += share * std::popcount(seen);
                free &= ~seen;
            }
            free_samples += std::popcount(free);
        }
        answer.background = share * free_samples;
    }

  private:
    static std::uint64_t bits_below(int n) {
        return n >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
    }

    /// The first sample whose middle is not left of x.
    int first_at_or_after(double x) const { return static_cast<int>(std::ceil(x * side_ - 0.5)); }

    std::uint64_t samples_in(const Ring& ring, double y) const {
        double from = 2, to = -1;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point p = ring[i];
            const Point q = ring[i + 1 == ring.size() ? 0 : i + 1];
            if ((p.y <= y) == (q.y <= y)) continue;
            const double x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
            from = std::min(from, x);
            to = std::max(to, x);
        }
        if (from >= to) return 0;
        return bits_below(first_at_or_after(to)) & ~bits_below(first_at_or_after(from));
    }

    int side_;
};

}  // namespace

Peer sampling(int side) {
    KEIKAN_CHECK(side >= 1 && side <= kMostSamplesAside, side << " samples aside");
    const std::string name = std::to_string(side) + "x" + std::to_string(side);
    return {.name = "sampling-" + name, .version = name + " samples", .start = [side]() -> Ask {
                return Sampling(side);
            }};
}

}  // namespace keikan::peers
