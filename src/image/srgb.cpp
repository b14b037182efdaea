// SPDX-License-Identifier: Apache-2.0
#include "keikan/image/srgb.hpp"

#include <cmath>
#include <limits>

#include "keikan/support/check.hpp"

namespace keikan {

double srgb_from_linear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linear_from_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

SrgbCodes::SrgbCodes(int bits) {
    const int max = (1 << bits) - 1;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    limits_.assign(static_cast<std::size_t>(max) + 2, 0);
    limits_.back() = kInfinity;
    for (int code = 1; code <= max; ++code) {
        const double exact = linear_from_srgb((code - 0.5) / max);
        const auto nearest = static_cast<float>(exact);
        limits_[static_cast<std::size_t>(code)] =
            nearest < exact ? std::nextafter(nearest, kInfinity) : nearest;
    }
    const auto place = [](std::size_t piece, int shift) {
        return std::bit_cast<float>(std::bit_cast<std::uint32_t>(kFirst) +
                                    (static_cast<std::uint32_t>(piece) << shift));
    };
    for (std::size_t i = 0; i < kPieces; ++i) {
        const auto at = [&](std::size_t piece) { return place(piece, kPieceShift); };
        // Between two ends of a piece the curve is straight within a tenth of a code of 16 bits.
        const double begin = at(i), end = at(i + 1);
        const double at_begin = max * srgb_from_linear(begin) + 0.5,
                     at_end = max * srgb_from_linear(end) + 0.5;
        pieces_[i] = {at(i), static_cast<float>(at_begin),
                      static_cast<float>((at_end - at_begin) / (end - begin))};
    }
    if (bits != 8) return;
    for (std::size_t i = 0; i < first_of_eight_.size(); ++i)
        first_of_eight_[i] = static_cast<std::uint8_t>((*this)(place(i, kEightShift)));
}

const SrgbCodes& SrgbCodes::of_bits(int bits) {
    KEIKAN_CHECK(bits == 8 || bits == 16, "sRGB codes of " << bits << " bits");
    if (bits == 8) {
        static const SrgbCodes eight(8);
        return eight;
    }
    static const SrgbCodes sixteen(16);
    return sixteen;
}

}  // namespace keikan
