// SPDX-License-Identifier: GPL-3.0-or-later
#include "rational_lines.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace keikan::oracle {
namespace {

/// A point of the pixel lies on that side of a line on which the rounded value says that it lies, if the
/// value is larger than this: x and y are off by 2^-50 and at most 1, a, b, c by 2^-52 of their size, which
/// is at most 1, and five roundings add 2^-53 of a sum of at most 3.
constexpr double kUncertainValue = 0x1p-47;

/// Within 2^-50 of over / (under * 2^bits), if that is at most 1 in size.
double quotient(const mpz_class& over, const mpz_class& under, int bits) {
    long over_exponent = 0, under_exponent = 0;
    const double first = mpz_get_d_2exp(&over_exponent, over.get_mpz_t());
    const double second = mpz_get_d_2exp(&under_exponent, under.get_mpz_t());
    return std::ldexp(first / second, static_cast<int>(over_exponent - under_exponent - bits));
}

/// result = p s - q r
void set_minor(mpz_class& result, const mpz_class& p, const mpz_class& q, const mpz_class& r,
               const mpz_class& s) {
    mpz_mul(result.get_mpz_t(), p.get_mpz_t(), s.get_mpz_t());
    mpz_submul(result.get_mpz_t(), q.get_mpz_t(), r.get_mpz_t());
}

/// Bits below the last 1 of a number that is not 0; of 0 the largest number.
mp_bitcnt_t zeros(const mpz_class& value) {
    return mpz_scan1(value.get_mpz_t(), 0);
}

/// A number within 2^-52 of its size: mantissa * 2^exponent, 1/2 <= |mantissa| < 1.
struct Rounded {
    long exponent = 0;
    double mantissa;
    explicit Rounded(const mpz_class& value) : mantissa(mpz_get_d_2exp(&exponent, value.get_mpz_t())) {}
};

/// The sign of line.a point.x + line.b point.y + line.c point.w, or 0 where rounded numbers cannot tell. What
/// matters is the size of the three products beside each other, however small all of them are.
int likely_side(const RationalLine& line, const RationalCorner& point) {
    struct Product {
        double value;
        long exponent;
    };
    const auto product = [](const mpz_class& p, const mpz_class& q) -> Product {
        const Rounded first(p), second(q);
        return {first.mantissa * second.mantissa, first.exponent + second.exponent};
    };
    const Product terms[] = {product(line.a, point.x), product(line.b, point.y), product(line.c, point.w)};
    long largest = 0;
    bool any = false;
    for (const auto& [value, exponent] : terms)
        if (value != 0 && (!any || exponent > largest)) largest = exponent, any = true;
    double sum = 0;
    for (const auto& [value, exponent] : terms)
        if (value != 0) sum += std::ldexp(value, static_cast<int>(exponent - largest));
    // Each of the three is at most 1 and off by 2^-50 of that; the sums add 2^-53 of at most 3, twice.
    constexpr double kUncertainSum = 0x1p-47;
    return std::abs(sum) > kUncertainSum ? (sum > 0 ? 1 : -1) : 0;
}

/// From this length on, in limbs, rounding six numbers first costs less than multiplying them.
constexpr std::size_t kLongNumber = 6;

KeyTable::Key key_of(std::uint32_t first, std::uint32_t second) {
    return {std::min(first, second), std::max(first, second)};
}

}  // namespace

int bits_after_the_point(double value) {
    if (value == 0) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);  // in [1/2, 1), at most 53 bits
    const auto whole = static_cast<std::int64_t>(std::ldexp(std::abs(mantissa), 53));
    return std::max(0, 53 - exponent - std::countr_zero(static_cast<std::uint64_t>(whole)));
}

mpz_class scaled(double value, int bits) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    mpz_class whole(std::ldexp(mantissa, 53));
    const int shift = exponent - 53 + bits;
    if (shift >= 0) return whole << static_cast<mp_bitcnt_t>(shift);
    return whole >> static_cast<mp_bitcnt_t>(-shift);  // drops zeros only
}

void RationalLines::start(PixelIndex pixel, int unit_bits) {
    pixel_ = pixel;
    unit_bits_ = unit_bits;
    corners_.forget_all();
    lines_.forget_all();
    corner_of_point_.forget_all();
    line_of_corners_.forget_all();
    corner_of_lines_.forget_all();
}

RationalCorner& RationalLines::fresh_corner() {
    RationalCorner& corner = corners_.next();
    corner.first = corner.second = nullptr;
    corner.index = static_cast<std::uint32_t>(corners_.size() - 1);
    return corner;
}

const RationalCorner* RationalLines::pixel_corner(int x, int y) {
    return corner(Point{double(pixel_.x + x), double(pixel_.y + y)});
}

/// result = (value - pixel) * 2^unit_bits
void RationalLines::set_scaled(mpz_class& result, double value, int pixel) const {
    int exponent = 0;
    result = std::ldexp(std::frexp(value, &exponent), 53);
    const int shift = exponent - 53 + unit_bits_;
    if (shift >= 0)
        result <<= static_cast<mp_bitcnt_t>(shift);
    else
        result >>= static_cast<mp_bitcnt_t>(-shift);  // drops zeros only
    if (pixel != 0) result -= mpz_class(pixel) << static_cast<mp_bitcnt_t>(unit_bits_);
}

const RationalCorner* RationalLines::corner(Point p) {
    p = {p.x + 0.0, p.y + 0.0};  // one zero
    const auto fresh = static_cast<std::int32_t>(corners_.size());
    const std::int32_t known =
        corner_of_point_.value({std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y)}, fresh);
    if (known != fresh) return &corners_[static_cast<std::size_t>(known)];
    RationalCorner& corner = fresh_corner();
    set_scaled(corner.x, p.x, pixel_.x);
    set_scaled(corner.y, p.y, pixel_.y);
    corner.w = 1;
    corner.near_x = quotient(corner.x, corner.w, unit_bits_);
    corner.near_y = quotient(corner.y, corner.w, unit_bits_);
    return &corner;
}

const RationalCorner* RationalLines::corner(const RationalPoint& p) {
    RationalCorner& corner = fresh_corner();
    corner.x = (p.x - pixel_.x * p.w) << static_cast<mp_bitcnt_t>(unit_bits_);
    corner.y = (p.y - pixel_.y * p.w) << static_cast<mp_bitcnt_t>(unit_bits_);
    corner.w = p.w;
    corner.near_x = quotient(corner.x, corner.w, unit_bits_);
    corner.near_y = quotient(corner.y, corner.w, unit_bits_);
    const std::int32_t known = corner_of_point_.value(
        {std::bit_cast<std::uint64_t>(corner.near_x), std::bit_cast<std::uint64_t>(corner.near_y)},
        static_cast<std::int32_t>(corner.index));
    const RationalCorner& near = corners_[static_cast<std::size_t>(known)];
    const bool same = near.x * corner.w == corner.x * near.w && near.y * corner.w == corner.y * near.w;
    return same ? &near : &corner;
}

const RationalLine* RationalLines::finished(RationalLine& line) {
    // Common factors 2^n would only make every later number longer.
    const mp_bitcnt_t common = std::min({zeros(line.a), zeros(line.b), zeros(line.c)});
    if (common > 0) {
        line.a >>= common;
        line.b >>= common;
        line.c >>= common;
    }
    long a_exponent = 0, b_exponent = 0, c_exponent = 0;
    const double a = mpz_get_d_2exp(&a_exponent, line.a.get_mpz_t());
    const double b = mpz_get_d_2exp(&b_exponent, line.b.get_mpz_t());
    const double c = mpz_get_d_2exp(&c_exponent, line.c.get_mpz_t());
    a_exponent = a == 0 ? 0 : a_exponent + unit_bits_;
    b_exponent = b == 0 ? 0 : b_exponent + unit_bits_;
    const long longest = std::max({a_exponent, b_exponent, c_exponent});
    line.near_a = std::ldexp(a, static_cast<int>(a_exponent - longest));
    line.near_b = std::ldexp(b, static_cast<int>(b_exponent - longest));
    line.near_c = std::ldexp(c, static_cast<int>(c_exponent - longest));
    return &line;
}

DirectedLine RationalLines::line_through(const RationalCorner* p, const RationalCorner* q) {
    const auto fresh = static_cast<std::int32_t>(lines_.size());
    const std::int32_t known = line_of_corners_.value(key_of(p->index, q->index), fresh);
    if (known != fresh) {
        const RationalLine* line = &lines_[static_cast<std::size_t>(known)];
        return {line, line->from == p ? 1 : -1};
    }
    RationalLine& line = lines_.next();
    line.from = p;
    line.to = q;
    line.index = static_cast<std::uint32_t>(fresh);
    set_minor(line.a, p->y, q->y, p->w, q->w);
    set_minor(line.b, q->x, p->x, q->w, p->w);
    set_minor(line.c, p->x, p->y, q->x, q->y);
    return {finished(line), 1};
}

const RationalLine* RationalLines::line_of(const mpz_class& a, const mpz_class& b, const mpz_class& c) {
    RationalLine& line = lines_.next();
    line.from = line.to = nullptr;
    line.index = static_cast<std::uint32_t>(lines_.size() - 1);
    line.a = a;
    line.b = b;
    line.c = c << static_cast<mp_bitcnt_t>(unit_bits_);
    return finished(line);
}

void RationalLines::lines_meet_at(const RationalLine* first, const RationalLine* second,
                                  const RationalCorner* corner) {
    corner_of_lines_.value(key_of(first->index, second->index), static_cast<std::int32_t>(corner->index));
}

const RationalCorner* RationalLines::meeting_point(const RationalLine* first, const RationalLine* second) {
    const auto fresh = static_cast<std::int32_t>(corners_.size());
    const std::int32_t known = corner_of_lines_.value(key_of(first->index, second->index), fresh);
    if (known != fresh) return &corners_[static_cast<std::size_t>(known)];
    RationalCorner& point = fresh_corner();
    point.first = first;
    point.second = second;
    set_minor(point.x, first->b, first->c, second->b, second->c);
    set_minor(point.y, first->c, first->a, second->c, second->a);
    set_minor(point.w, first->a, first->b, second->a, second->b);
    if (point.w < 0) {
        mpz_neg(point.x.get_mpz_t(), point.x.get_mpz_t());
        mpz_neg(point.y.get_mpz_t(), point.y.get_mpz_t());
        mpz_neg(point.w.get_mpz_t(), point.w.get_mpz_t());
    }
    point.near_x = quotient(point.x, point.w, unit_bits_);
    point.near_y = quotient(point.y, point.w, unit_bits_);
    return &point;
}

int RationalLines::side(const RationalCorner& point, DirectedLine along) {
    const RationalLine& line = *along.line;
    if (point.first == &line || point.second == &line || line.from == &point || line.to == &point) return 0;
    const double value = line.near_a * point.near_x + line.near_b * point.near_y + line.near_c;
    if (std::abs(value) > kUncertainValue) return value > 0 ? along.sense : -along.sense;
    if (mpz_size(point.w.get_mpz_t()) >= kLongNumber)
        if (const int likely = likely_side(line, point); likely != 0) return along.sense * likely;
    mpz_mul(sum_.get_mpz_t(), line.a.get_mpz_t(), point.x.get_mpz_t());
    mpz_addmul(sum_.get_mpz_t(), line.b.get_mpz_t(), point.y.get_mpz_t());
    mpz_addmul(sum_.get_mpz_t(), line.c.get_mpz_t(), point.w.get_mpz_t());
    return along.sense * sgn(sum_);
}

bool RationalLines::turns_left(const RationalCorner& p, const RationalCorner& q, const RationalCorner& r) {
    set_minor(sum_, q.y, r.y, q.w, r.w);
    mpz_mul(third_sum_.get_mpz_t(), p.x.get_mpz_t(), sum_.get_mpz_t());
    set_minor(sum_, r.x, q.x, r.w, q.w);
    mpz_addmul(third_sum_.get_mpz_t(), p.y.get_mpz_t(), sum_.get_mpz_t());
    set_minor(sum_, q.x, q.y, r.x, r.y);
    mpz_addmul(third_sum_.get_mpz_t(), p.w.get_mpz_t(), sum_.get_mpz_t());
    return third_sum_ > 0;
}

}  // namespace keikan::oracle
