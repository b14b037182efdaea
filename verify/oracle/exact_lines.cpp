// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long the numbers are. With coordinates below 2^24 pixels that are multiples of 2^-100 (every double of
// a size of 2^-47 or more is one), a point is two whole numbers below 2^124, and
//     a, b        < 2^125     2 limbs        w = a b' - a' b   < 2^251    4 limbs
//     c           < 2^249     4 limbs        x = b c' - b' c   < 2^375    6 limbs
//     a'' x + b'' y + c'' w < 2^502          8 limbs.
// What does not fit (denormal numbers near the image's first column, absurd extents) is taken in GMP's
// integers instead. Both are exact.
#include "exact_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include "exact_double.hpp"

namespace keikan::oracle {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64, "vertices are placed in 64 bits");

constexpr int kUnitBits = 100;
constexpr int kCoordinateLength = 124;

/// With u = 2^-53: a vertex is off by u, a coefficient by 2 u of its size, the products, their sum and the
/// last sum by u each; so a x + b y + c errs by at most 6 u (|a| + |b| + |c|), x and y being at most 1.
constexpr double kValueError = 0x1p-50;

using Corner = std::optional<std::pair<Int128, Int128>>;

/// Pixel-local, in units of 2^-kUnitBits, if it fits.
Corner whole_corner(Point p, PixelIndex pixel) {
    const auto x = whole_number(p.x, kUnitBits, kCoordinateLength - 1);
    const auto y = whole_number(p.y, kUnitBits, kCoordinateLength - 1);
    constexpr int kFarthestPixel = 1 << 22;
    if (!x || !y || std::abs(pixel.x) > kFarthestPixel || std::abs(pixel.y) > kFarthestPixel)
        return std::nullopt;
    const Int128 one = static_cast<Int128>(1) << kUnitBits;
    return std::pair(*x - one * pixel.x, *y - one * pixel.y);
}

std::uint64_t bits(double value) {
    return std::bit_cast<std::uint64_t>(value + 0.0);
}  // one zero only

int least_exponent(std::initializer_list<double> values) {
    int least = 0;
    for (const double value : values) least = std::min(least, binary_fraction(value).exponent);
    return least;
}

/// value * 2^exponent; std::ldexp in the range that occurs here, without its checks.
long double scaled(long double value, int exponent) {
    return value *
           static_cast<long double>(std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52));
}

double scaled_double(const Leading& number, int exponent) {
    return static_cast<double>(scaled(number.mantissa, number.exponent + exponent));
}

}  // namespace

void ExactLines::start(PixelIndex pixel) {
    pixel_ = pixel;
    if (lines_.empty()) add_borders();
    lines_.resize(4);
    exact_lines_.resize(4);
    for (Line& border : lines_) border.any_length = -1;
    forget_vertices_from(4);
    long_lines_.clear();
    corners_.forget_all();
    edges_.forget_all();
}

/// The same for every pixel, since coordinates are pixel-local.
void ExactLines::add_borders() {
    const auto border = [this](int a, int b, int c) {
        const WideInteger<4> away = WideInteger<2>(static_cast<Int128>(1) << kUnitBits) * WideInteger<2>(c);
        add_line(ExactLine{WideInteger<2>(a), WideInteger<2>(b), away}, -1, -1);
    };
    border(0, 1, 0);   // y >= 0
    border(-1, 0, 1);  // x <= 1
    border(0, -1, 1);  // y <= 1
    border(1, 0, 0);   // x >= 0
    for (LineId i = 0; i < 4; ++i) meeting_point((i + 3) % 4, i);
}

LineId ExactLines::add_line(const ExactLine& line, std::int32_t from, std::int32_t to) {
    Line rounded{};
    rounded.a = scaled_double(leading(line.a), 0);
    rounded.b = scaled_double(leading(line.b), 0);
    rounded.c = scaled_double(leading(line.c), -kUnitBits);
    // a, b are whole numbers, one of them not 0: nothing here can underflow that matters.
    rounded.uncertain = kValueError * (std::abs(rounded.a) + std::abs(rounded.b) + std::abs(rounded.c));
    rounded.from = from;
    rounded.to = to;
    rounded.fits = true;
    rounded.any_length = -1;
    lines_.push_back(rounded);
    exact_lines_.push_back(line);
    return static_cast<LineId>(lines_.size() - 1);
}

LineId ExactLines::add_line(AnyLength&& line, std::int32_t from, std::int32_t to) {
    // A common factor makes the largest of a, b and c (per pixel) about 1.
    long a_exponent = 0, b_exponent = 0, c_exponent = 0;
    const double a = mpz_get_d_2exp(&a_exponent, line.x.get_mpz_t());
    const double b = mpz_get_d_2exp(&b_exponent, line.y.get_mpz_t());
    const double c = mpz_get_d_2exp(&c_exponent, line.w.get_mpz_t());
    c_exponent -= kUnitBits;
    long largest = std::numeric_limits<long>::min();
    if (a != 0) largest = std::max(largest, a_exponent);
    if (b != 0) largest = std::max(largest, b_exponent);
    if (c != 0) largest = std::max(largest, c_exponent);
    const auto shifted = [largest](double value, long exponent) {
        return value == 0 ? 0 : std::ldexp(value, static_cast<int>(exponent - largest));
    };
    Line rounded{};
    rounded.a = shifted(a, a_exponent);
    rounded.b = shifted(b, b_exponent);
    rounded.c = shifted(c, c_exponent);
    rounded.uncertain = kValueError * (std::abs(rounded.a) + std::abs(rounded.b) + std::abs(rounded.c));
    rounded.from = from;
    rounded.to = to;
    rounded.fits = false;
    rounded.any_length = static_cast<std::int32_t>(long_lines_.size());
    line.round();
    long_lines_.push_back(std::move(line));
    lines_.push_back(rounded);
    exact_lines_.emplace_back();
    return static_cast<LineId>(lines_.size() - 1);
}

std::int32_t ExactLines::corner(Point p) {
    std::int32_t& known = corners_.value({bits(p.x), bits(p.y)}, -1);
    if (known < 0) known = static_cast<std::int32_t>(corners_.count() - 1);
    return known;
}

SidedLine ExactLines::line_through(Point p, Point q) {
    std::int32_t from = corner(p), to = corner(q);
    const int sense = from < to ? 1 : -1;
    if (sense < 0) {
        std::swap(from, to);
        std::swap(p, q);
    }
    std::int32_t& known =
        edges_.value({static_cast<std::uint64_t>(from), static_cast<std::uint64_t>(to)}, -1);
    if (known >= 0) return {known, sense};

    const Corner start = whole_corner(p, pixel_), end = whole_corner(q, pixel_);
    if (start && end) {
        const auto& [px, py] = *start;
        const auto& [qx, qy] = *end;
        const auto c = WideInteger<2>(px) * WideInteger<2>(qy) - WideInteger<2>(py) * WideInteger<2>(qx);
        known = add_line(ExactLine{WideInteger<2>(py - qy), WideInteger<2>(qx - px), c}, from, to);
        return {known, sense};
    }
    // In units of 2^-n pixels, n large enough: (A, B, C). In units of 2^-kUnitBits: C is 2^(kUnitBits - n)
    // times as much; A and B are multiplied instead, since n >= kUnitBits.
    const int n = std::max(kUnitBits, -least_exponent({p.x, p.y, q.x, q.y}));
    const mpz_class one = mpz_class(1) << static_cast<mp_bitcnt_t>(n);
    const mpz_class px = whole_number_of_any_length(p.x, n) - pixel_.x * one;
    const mpz_class py = whole_number_of_any_length(p.y, n) - pixel_.y * one;
    const mpz_class qx = whole_number_of_any_length(q.x, n) - pixel_.x * one;
    const mpz_class qy = whole_number_of_any_length(q.y, n) - pixel_.y * one;
    const auto finer = static_cast<mp_bitcnt_t>(n - kUnitBits);
    known = add_line(AnyLength{(py - qy) << finer, (qx - px) << finer, px * qy - py * qx, 0, 0, 0}, from, to);
    return {known, sense};
}

SidedLine ExactLines::line_of_equal_depth(const DepthPlane& nearer, const DepthPlane& farther) {
    const std::array<double, 6> values = {nearer.a, nearer.b, nearer.c, farther.a, farther.b, farther.c};
    int least = std::numeric_limits<int>::max();
    for (const double value : values)
        if (value != 0) least = std::min(least, binary_fraction(value).exponent);

    // Coefficients below 2^108 give differences below 2^109, a constant below 2^123 at the pixel's corner (an
    // index is below 2^13), and that 2^100 times, below 2^223.
    std::array<Int128, 6> whole{};
    bool fits = true;
    for (std::size_t i = 0; i < 6 && fits; ++i) {
        const auto number = whole_number(values[i], -least, 108);
        fits = number.has_value();
        whole[i] = number.value_or(0);
    }
    if (fits && std::max(std::abs(pixel_.x), std::abs(pixel_.y)) < (1 << 13)) {
        const Int128 a = whole[0] - whole[3], b = whole[1] - whole[4];
        const Int128 c = whole[2] - whole[5] + a * pixel_.x + b * pixel_.y;
        const Int128 one = static_cast<Int128>(1) << kUnitBits;
        return {
            add_line(ExactLine{WideInteger<2>(a), WideInteger<2>(b), WideInteger<2>(c) * WideInteger<2>(one)},
                     -1, -1),
            1};
    }
    std::array<mpz_class, 6> number;
    for (std::size_t i = 0; i < 6; ++i) number[i] = whole_number_of_any_length(values[i], -least);
    const mpz_class a = number[0] - number[3], b = number[1] - number[4];
    const mpz_class c = number[2] - number[5] + a * pixel_.x + b * pixel_.y;
    return {add_line(AnyLength{a, b, c << kUnitBits, 0, 0, 0}, -1, -1), 1};
}

namespace {

/// over / under in pixels, in units of 2^-kFixedBits. Either is known to 2^-63 of its size and the quotient
/// is rounded by 2^-64 of its own, which is at most 1: together 1.25 units, and half a unit for the whole
/// number, below 2.
std::int64_t fixed_quotient(const Leading& over, const Leading& under) {
    constexpr int kUnits = ExactLines::kFixedBits - kUnitBits;
    return std::llrint(scaled(over.mantissa / under.mantissa, over.exponent - under.exponent + kUnits));
}

}  // namespace

VertexId ExactLines::meeting_point(LineId first, LineId second) {
    Vertex vertex{};
    vertex.first = first;
    vertex.second = second;
    vertex.any_length = -1;
    const Line& l = lines_[static_cast<std::size_t>(first)];
    const Line& m = lines_[static_cast<std::size_t>(second)];
    vertex.corner = -1;
    if (l.from >= 0 && (l.from == m.from || l.from == m.to)) vertex.corner = l.from;
    if (l.to >= 0 && (l.to == m.from || l.to == m.to)) vertex.corner = l.to;
    if (!l.fits || !m.fits) return meeting_point_of_any_length(vertex);

    const ExactLine& p = exact_lines_[static_cast<std::size_t>(first)];
    const ExactLine& q = exact_lines_[static_cast<std::size_t>(second)];
    ExactVertex exact{p.b * q.c - q.b * p.c, q.a * p.c - p.a * q.c, p.a * q.b - q.a * p.b};
    if (exact.w.negative()) exact = {-exact.x, -exact.y, -exact.w};
    const Leading under = leading(exact.w);
    vertex.fixed_x = fixed_quotient(leading(exact.x), under);
    vertex.fixed_y = fixed_quotient(leading(exact.y), under);
    vertex.x = static_cast<double>(vertex.fixed_x) * 0x1p-62;
    vertex.y = static_cast<double>(vertex.fixed_y) * 0x1p-62;
    vertices_.push_back(vertex);
    exact_vertices_.push_back(exact);
    return static_cast<VertexId>(vertices_.size() - 1);
}

void ExactLines::AnyLength::round() {
    const auto rounded = [](const mpz_class& value) {
        long exponent = 0;
        const double mantissa = mpz_get_d_2exp(&exponent, value.get_mpz_t());
        return std::ldexp(static_cast<long double>(mantissa), static_cast<int>(exponent));
    };
    near_x = rounded(x);
    near_y = rounded(y);
    near_w = rounded(w);
}

const ExactLines::AnyLength& ExactLines::any_length_line(LineId line) {
    Line& l = lines_[static_cast<std::size_t>(line)];
    if (l.any_length < 0) {
        const ExactLine& exact = exact_lines_[static_cast<std::size_t>(line)];
        l.any_length = static_cast<std::int32_t>(long_lines_.size());
        AnyLength& copy = long_lines_.emplace_back();
        assign(copy.x.get_mpz_t(), exact.a);
        assign(copy.y.get_mpz_t(), exact.b);
        assign(copy.w.get_mpz_t(), exact.c);
        copy.round();
    }
    return long_lines_[static_cast<std::size_t>(l.any_length)];
}

namespace {

/// result = p s - q r
void determinant(mpz_class& result, const mpz_class& p, const mpz_class& q, const mpz_class& r,
                 const mpz_class& s) {
    mpz_mul(result.get_mpz_t(), p.get_mpz_t(), s.get_mpz_t());
    mpz_submul(result.get_mpz_t(), q.get_mpz_t(), r.get_mpz_t());
}

}  // namespace

VertexId ExactLines::meeting_point_of_any_length(Vertex vertex) {
    const AnyLength& p = any_length_line(vertex.first);
    const AnyLength& q = any_length_line(vertex.second);
    vertex.any_length = static_cast<std::int32_t>(long_vertices_.size());
    AnyLength& exact = long_vertices_.emplace_back();
    determinant(exact.x, p.y, p.w, q.y, q.w);
    determinant(exact.y, p.w, p.x, q.w, q.x);
    determinant(exact.w, p.x, p.y, q.x, q.y);
    if (exact.w < 0)
        for (mpz_class* part : {&exact.x, &exact.y, &exact.w}) mpz_neg(part->get_mpz_t(), part->get_mpz_t());
    exact.round();

    // x / w in pixels is x / (2^kUnitBits w); cut off, that is, less than one unit off.
    mpz_mul_2exp(sum_.w.get_mpz_t(), exact.w.get_mpz_t(), kUnitBits - kFixedBits);
    mpz_tdiv_q(sum_.x.get_mpz_t(), exact.x.get_mpz_t(), sum_.w.get_mpz_t());
    mpz_tdiv_q(sum_.y.get_mpz_t(), exact.y.get_mpz_t(), sum_.w.get_mpz_t());
    vertex.fixed_x = sum_.x.get_si();
    vertex.fixed_y = sum_.y.get_si();
    vertex.x = static_cast<double>(vertex.fixed_x) * 0x1p-62;
    vertex.y = static_cast<double>(vertex.fixed_y) * 0x1p-62;
    vertices_.push_back(vertex);
    exact_vertices_.emplace_back();
    return static_cast<VertexId>(vertices_.size() - 1);
}

int ExactLines::exact_side(VertexId vertex, LineId line) {
    if (vertices_[static_cast<std::size_t>(vertex)].any_length >= 0 ||
        !lines_[static_cast<std::size_t>(line)].fits)
        return side_of_any_length(vertex, line);
    const ExactLine& l = exact_lines_[static_cast<std::size_t>(line)];
    const ExactVertex& exact = exact_vertices_[static_cast<std::size_t>(vertex)];
    return (l.a * exact.x + l.b * exact.y + l.c * exact.w).sign();
}

int ExactLines::side_of_any_length(VertexId vertex, LineId line) {
    const AnyLength& l = any_length_line(line);
    const AnyLength* exact = &point_;
    const std::int32_t place = vertices_[static_cast<std::size_t>(vertex)].any_length;
    if (place >= 0) {
        exact = &long_vertices_[static_cast<std::size_t>(place)];
    } else {
        const ExactVertex& wide = exact_vertices_[static_cast<std::size_t>(vertex)];
        assign(point_.x.get_mpz_t(), wide.x);
        assign(point_.y.get_mpz_t(), wide.y);
        assign(point_.w.get_mpz_t(), wide.w);
        point_.round();
    }
    // Six factors within 2^-52, five roundings by 2^-64. What is too large for the type compares as false.
    const long double first = l.near_x * exact->near_x, second = l.near_y * exact->near_y;
    const long double third = l.near_w * exact->near_w, value = first + second + third;
    const long double uncertain = 0x1p-50L * (std::abs(first) + std::abs(second) + std::abs(third));
    if (value > uncertain) return 1;
    if (value < -uncertain) return -1;
    mpz_mul(sum_.x.get_mpz_t(), l.x.get_mpz_t(), exact->x.get_mpz_t());
    mpz_addmul(sum_.x.get_mpz_t(), l.y.get_mpz_t(), exact->y.get_mpz_t());
    mpz_addmul(sum_.x.get_mpz_t(), l.w.get_mpz_t(), exact->w.get_mpz_t());
    return sgn(sum_.x);
}

void ExactLines::forget_vertices_from(std::size_t count) {
    while (vertices_.size() > count) {
        if (vertices_.back().any_length >= 0) long_vertices_.pop_back();
        vertices_.pop_back();
        exact_vertices_.pop_back();
    }
}

}  // namespace keikan::oracle
