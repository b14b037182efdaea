// SPDX-License-Identifier: Apache-2.0
#include "encoded_case.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "keikan/cases/convex_ring.hpp"
#include "keikan/clip/convex_hull.hpp"

namespace keikan::fuzzers {
namespace {

constexpr std::size_t kMostPolygons = 8;
constexpr std::size_t kMostCorners = 7;
constexpr int kLargestPixel = 1 << 16;

// First bytes of a coordinate.
constexpr int kGridEnd = 160;                  ///< (byte - 16) / 128
constexpr int kAgainEnd = kGridEnd + 32;       ///< the coordinate so many before
constexpr int kUlpMoreEnd = kAgainEnd + 24;    ///< the same, an ulp more
constexpr int kUlpLessEnd = kUlpMoreEnd + 24;  ///< an ulp less; beyond: eight bytes follow
constexpr double kGridSteps = 128;
constexpr int kGridStart = 16;

constexpr std::uint8_t kHasDepth = 1, kHasPixel = 2;

class Decoder {
  public:
    explicit Decoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    bool at_end() const { return at_ == bytes_.size(); }
    std::uint8_t byte() { return at_end() ? std::uint8_t{0} : bytes_[at_++]; }

    double raw() {
        std::uint64_t bits = 0;
        for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
        const auto value = std::bit_cast<double>(bits);
        return std::isfinite(value) ? value : 0;
    }

    /// The next coordinate; every second one is of the same axis.
    double coordinate() {
        const int tag = byte();
        double value = 0;
        if (tag < kGridEnd)
            value = (tag - kGridStart) / kGridSteps;
        else if (tag < kAgainEnd)
            value = earlier(tag - kGridEnd);
        else if (tag < kUlpMoreEnd)
            value = std::nextafter(earlier(tag - kAgainEnd), 1e300);
        else if (tag < kUlpLessEnd)
            value = std::nextafter(earlier(tag - kUlpMoreEnd), -1e300);
        else
            value = raw();
        said_.push_back(value);
        return value;
    }

    int pixel_coordinate() {
        const int value = byte() << 8 | byte();
        return value - kLargestPixel / 2;
    }

  private:
    double earlier(int back) const {
        const auto steps = 2 * (static_cast<std::size_t>(back) + 1);
        return steps <= said_.size() ? said_[said_.size() - steps] : 0;
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
    std::vector<double> said_;
};

void encode(double value, std::string& out) {
    const double step = value * kGridSteps + kGridStart;
    if (step >= 0 && step < kGridEnd && step == std::floor(step) && !(value == 0 && std::signbit(value))) {
        out += static_cast<char>(static_cast<int>(step));
        return;
    }
    out += static_cast<char>(255);
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 56; shift >= 0; shift -= 8) out += static_cast<char>(bits >> shift & 0xFF);
}

void encode_pixel(int value, std::string& out) {
    const int shifted = value + kLargestPixel / 2;
    out += static_cast<char>(shifted >> 8 & 0xFF);
    out += static_cast<char>(shifted & 0xFF);
}

}  // namespace

PixelCase decoded_case(std::span<const std::uint8_t> bytes) {
    Decoder in(bytes);
    PixelCase result;
    const std::uint8_t flags = in.byte();
    if (flags & kHasDepth) result.depth.emplace();
    if (flags & kHasPixel) {
        const int x = in.pixel_coordinate();
        result.pixel = {x, in.pixel_coordinate()};
    }
    while (!in.at_end() && result.polygons.size() < kMostPolygons) {
        Ring ring;
        for (std::size_t n = in.byte() % (kMostCorners + 1); n > 0; --n) {
            const double x = in.coordinate();
            ring.push_back({x, in.coordinate()});
        }
        if (!is_convex_ring(ring)) clip::replace_by_hull(ring);
        result.polygons.push_back(std::move(ring));
        if (!result.depth) continue;
        const double a = in.coordinate(), b = in.coordinate();
        result.depth->push_back({a, b, in.coordinate()});
    }
    return result;
}

std::string encoded_case(const PixelCase& pixel_case) {
    const bool moved = pixel_case.pixel != PixelIndex{};
    std::string out(1, static_cast<char>((pixel_case.depth ? kHasDepth : 0) | (moved ? kHasPixel : 0)));
    if (moved) {
        encode_pixel(pixel_case.pixel.x, out);
        encode_pixel(pixel_case.pixel.y, out);
    }
    for (std::size_t i = 0; i < std::min(pixel_case.polygons.size(), kMostPolygons); ++i) {
        const Ring& ring = pixel_case.polygons[i];
        const std::size_t corners = std::min(ring.size(), kMostCorners);
        out += static_cast<char>(corners);
        for (std::size_t k = 0; k < corners; ++k) {
            encode(ring[k].x, out);
            encode(ring[k].y, out);
        }
        if (!pixel_case.depth) continue;
        const DepthPlane& plane = (*pixel_case.depth)[i];
        for (const double v : {plane.a, plane.b, plane.c}) encode(v, out);
    }
    return out;
}

}  // namespace keikan::fuzzers
