// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace keikan {

/// The sRGB transfer function (IEC 61966-2-1) from linear light to the encoded value, both in [0, 1]:
/// 12.92 x up to 0.0031308, 1.055 x^(1/2.4) - 0.055 above; and its inverse, with the switch at 0.04045.
double srgb_from_linear(double linear);
double linear_from_srgb(double encoded);

/// Linear light to sRGB codes 0 ... 2^bits - 1, rounded to nearest.
///
/// Property: (1) The code of x is k exactly when linear_from_srgb((k - 1/2) / max) <= x, and not so for k +
/// 1;
///               x <= 0 has code 0 and x >= 1 the largest, infinities among them.
/// Exact:    by comparison with those limits, each the smallest float for which (1) holds. The tests check
///           both sides of every limit, 8 and 16 bits, against long double.
/// Cost:     an interpolated guess, then nearly always two comparisons; no pow.
class SrgbCodes {
  public:
    /// 8 or 16 bits; each is made once and shared.
    static const SrgbCodes& of_bits(int bits);

    /// Requires: x is not NaN.
    std::uint16_t operator()(float x) const {
        if (!(x > kFirst)) x = kFirst;
        if (x >= 1) return static_cast<std::uint16_t>(limits_.size() - 2);
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(x) - std::bit_cast<std::uint32_t>(kFirst);
        const Piece& piece = pieces_[bits >> kPieceShift];
        auto code = static_cast<std::size_t>(piece.at_begin + piece.slope * (x - piece.begin));
        while (x < limits_[code]) --code;
        while (x >= limits_[code + 1]) ++code;
        return static_cast<std::uint16_t>(code);
    }

    /// The same for codes of 8 bits, faster: a table and one comparison. Requires: made of 8 bits.
    std::uint8_t eight(float x) const {
        x = x > kFirst ? x : kFirst;
        x = x < kLast ? x : kLast;
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(x) - std::bit_cast<std::uint32_t>(kFirst);
        const std::uint32_t code = first_of_eight_[bits >> kEightShift];
        return static_cast<std::uint8_t>(code + (x >= limits_[code + 1] ? 1 : 0));
    }

    /// The smallest float of each code: 0 for code 0, and one entry beyond the last that no value reaches.
    const std::vector<float>& limits() const { return limits_; }

  private:
    explicit SrgbCodes(int bits);

    // Half a code of 16 bits is 2^-17 / 12.92 = 2^-20.7, so below 2^-21 every code is 0: the table begins
    // there. A piece is 1/64 of an octave.
    static constexpr float kFirst = 0x1p-21f;
    static constexpr int kPieceShift = 23 - 6;
    static constexpr std::size_t kPieces = 21 << 6;
    struct Piece {
        float begin, at_begin, slope;
    };
    std::array<Piece, kPieces> pieces_{};
    // For 8 bits, the code at the begin of each 1/128 of an octave. Within it the curve rises by less than
    // 255 * 1.055 / 2.4 * ln(129/128) = 0.88 of a code, so at most one code begins there.
    static constexpr float kLast = 0x1.fffffep-1f;
    static constexpr int kEightShift = 23 - 7;
    std::array<std::uint8_t, 21 << 7> first_of_eight_{};
    std::vector<float> limits_;
};

}  // namespace keikan
