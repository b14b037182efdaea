// SPDX-License-Identifier: Apache-2.0
//
// Error-free sums and products of doubles, and the unevaluated sum of two of them. After Dekker 1971 and
// Shewchuk 1997. Only + - * / are used: no fused operation is needed. Where the compiler has one, it gives
// the error of a product at once: the bits are the same everywhere. Where a compiler fuses operations all the
// same, what is exact here stays exact.
#pragma once

namespace keikan::clip {

/// The number hi + lo. As long as it is normalised, hi is the double nearest to it.
struct DoubleDouble {
    double hi = 0;
    double lo = 0;
};

/// Half the distance from 1 to the next double: the relative error of one rounding.
inline constexpr double kHalfUlp = 0x1p-53;

/// x, as rounded as it is. A compiler that contracts (-ffp-contract=fast, on a machine with fused operations)
/// may otherwise form a product once more, unrounded, in a sum that follows, and what is exact here would not
/// be.
inline double rounded(double x) {
#if defined(__FMA__) && defined(__x86_64__)
    asm("" : "+x"(x));
#elif defined(__aarch64__)
    asm("" : "+w"(x));
#elif defined(__FP_FAST_FMA)
    asm("" : "+m"(x));
#endif
    return x;
}

/// a + b, exactly.
inline DoubleDouble two_sum(double a, double b) {
    a = rounded(a), b = rounded(b);
    const double sum = a + b;
    const double b_part = sum - a;
    const double a_part = sum - b_part;
    return {sum, (a - a_part) + (b - b_part)};
}

/// a - b, exactly.
inline DoubleDouble two_difference(double a, double b) {
    return two_sum(a, -b);
}

/// a + b, exactly. Requires |a| >= |b| or a = 0.
inline DoubleDouble quick_two_sum(double a, double b) {
    a = rounded(a), b = rounded(b);
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a in two halves of at most 26 bits, so that products of halves are exact. Requires |a| < 2^996.
inline DoubleDouble split(double a) {
    const double shifted = rounded(0x8000001p0 * a);  // 2^27 + 1
    const double hi = shifted - (shifted - a);
    return {hi, a - hi};
}

/// a * b, exactly, unless the error term underflows (|a b| < 2^-968) or a factor passes 2^996.
inline DoubleDouble two_product(double a, double b) {
    const double product = rounded(a * b);
#ifdef __FMA__
    return {product, __builtin_fma(a, b, -product)};
#else
    const DoubleDouble x = split(a);
    const DoubleDouble y = split(b);
    return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
#endif
}

/// x + y with a relative error of at most 3 * 2^-106 (Joldes, Muller, Popescu 2017, theorem 3.1).
inline DoubleDouble operator+(DoubleDouble x, DoubleDouble y) {
    const DoubleDouble high = two_sum(x.hi, y.hi);
    const DoubleDouble low = two_sum(x.lo, y.lo);
    const DoubleDouble sum = quick_two_sum(high.hi, high.lo + low.hi);
    return quick_two_sum(sum.hi, low.lo + sum.lo);
}

inline DoubleDouble operator-(DoubleDouble x) {
    return {-x.hi, -x.lo};
}
inline DoubleDouble operator-(DoubleDouble x, DoubleDouble y) {
    return x + -y;
}

/// x * y with a relative error of at most 6 * 2^-106 (the same source, theorem 5.1).
inline DoubleDouble operator*(DoubleDouble x, DoubleDouble y) {
    const DoubleDouble product = two_product(x.hi, y.hi);
    return quick_two_sum(product.hi, product.lo + (x.hi * y.lo + x.lo * y.hi));
}

/// x / y, off by at most half an ulp and 2^-98 of itself.
inline double quotient(DoubleDouble x, DoubleDouble y) {
    const double reciprocal = 1 / y.hi;
    const double first = rounded(x.hi * reciprocal);
    const DoubleDouble back = two_product(first, y.hi);
    const double rest = ((x.hi - back.hi) - back.lo) + (x.lo - first * y.lo);
    return first + rest * reciprocal;
}

}  // namespace keikan::clip
