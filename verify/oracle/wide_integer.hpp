// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmp.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace keikan::oracle {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

/// A whole number of fixed length: N limbs of 64 bits, two's complement, least significant first.
/// It wraps around: whoever uses it shows that its numbers fit. It is here, beside GMP, because the
/// certified rung asks for some hundred signs of determinants a pixel, and these need no memory and no
/// function calls (six times as fast as mpz at the lengths used).
template <int N>
struct WideInteger {
    std::array<std::uint64_t, static_cast<std::size_t>(N)> limb{};

    WideInteger() = default;
    explicit WideInteger(Int128 value) {
        limb[0] = static_cast<std::uint64_t>(value);
        limb[1] = static_cast<std::uint64_t>(value >> 64);
        for (int i = 2; i < N; ++i) limb[index(i)] = value < 0 ? ~std::uint64_t{0} : 0;
    }

    bool negative() const { return (limb[N - 1] >> 63) != 0; }

    /// -1, 0 or 1.
    int sign() const {
        if (negative()) return -1;
        std::uint64_t any = 0;
        for (const std::uint64_t part : limb) any |= part;
        return any != 0 ? 1 : 0;
    }

    WideInteger& operator+=(const WideInteger& other) {
        UInt128 carry = 0;
        for (int i = 0; i < N; ++i) {
            carry += static_cast<UInt128>(limb[index(i)]) + other.limb[index(i)];
            limb[index(i)] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        return *this;
    }

    WideInteger& operator-=(const WideInteger& other) {
        std::uint64_t borrow = 0;
        for (int i = 0; i < N; ++i) {
            const UInt128 part = static_cast<UInt128>(limb[index(i)]) - other.limb[index(i)] - borrow;
            limb[index(i)] = static_cast<std::uint64_t>(part);
            borrow = static_cast<std::uint64_t>(part >> 64) & 1;
        }
        return *this;
    }

    WideInteger operator-() const {
        WideInteger result;
        result -= *this;
        return result;
    }

    friend WideInteger operator+(WideInteger a, const WideInteger& b) { return a += b; }
    friend WideInteger operator-(WideInteger a, const WideInteger& b) { return a -= b; }

    static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }
};

/// The product, which always fits.
template <int N, int M>
WideInteger<N + M> operator*(const WideInteger<N>& a, const WideInteger<M>& b) {
    WideInteger<N + M> result;
    for (int i = 0; i < N; ++i) {
        std::uint64_t carry = 0;
        for (int j = 0; j < M; ++j) {
            std::uint64_t& place = result.limb[static_cast<std::size_t>(i + j)];
            const UInt128 part = static_cast<UInt128>(a.limb[static_cast<std::size_t>(i)]) *
                                     b.limb[static_cast<std::size_t>(j)] +
                                 place + carry;
            place = static_cast<std::uint64_t>(part);
            carry = static_cast<std::uint64_t>(part >> 64);
        }
        result.limb[static_cast<std::size_t>(i + M)] = carry;
    }
    // So far both were read as unsigned: a negative a counted as a + 2^(64 N), which gave b 2^(64 N) too
    // much.
    const auto take_from_limb = [&result](int from, const auto& number, int length) {
        std::uint64_t borrow = 0;
        for (int i = 0; i < length; ++i) {
            std::uint64_t& place = result.limb[static_cast<std::size_t>(from + i)];
            const UInt128 part =
                static_cast<UInt128>(place) - number.limb[static_cast<std::size_t>(i)] - borrow;
            place = static_cast<std::uint64_t>(part);
            borrow = static_cast<std::uint64_t>(part >> 64) & 1;
        }
    };
    if (a.negative()) take_from_limb(N, b, M);
    if (b.negative()) take_from_limb(M, a, N);
    return result;
}

/// A number as mantissa * 2^exponent, 2^63 <= |mantissa| < 2^64, off by less than one unit of the mantissa
/// (a relative error below 2^-63); 0 is {0, 0}.
struct Leading {
    long double mantissa = 0;
    int exponent = 0;
};

template <int N>
Leading leading(const WideInteger<N>& value) {
    const bool negative = value.negative();
    const WideInteger<N> size = negative ? -value : value;
    int top = N - 1;
    while (top >= 0 && size.limb[static_cast<std::size_t>(top)] == 0) --top;
    if (top < 0) return {};
    std::uint64_t bits = size.limb[static_cast<std::size_t>(top)];
    const int zeros = std::countl_zero(bits);
    if (zeros > 0) {
        bits <<= zeros;
        if (top > 0) bits |= size.limb[static_cast<std::size_t>(top - 1)] >> (64 - zeros);
    }
    const auto mantissa = static_cast<long double>(bits);
    return {negative ? -mantissa : mantissa, 64 * top - zeros};
}

/// Requires: `result` initialized.
template <int N>
void assign(mpz_ptr result, const WideInteger<N>& value) {
    const WideInteger<N> size = value.negative() ? -value : value;
    mpz_import(result, N, -1, sizeof(std::uint64_t), 0, 0, size.limb.data());
    if (value.negative()) mpz_neg(result, result);
}

}  // namespace keikan::oracle
