// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmpxx.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "exact_areas.hpp"
#include "key_table.hpp"

// The lines of one pixel and the points where they meet, for rational splitting: in whole numbers of any
// length.
//
// Coordinates are pixel-local, in units of 2^-unit_bits pixels, chosen so that every corner of an outline is
// a point of whole numbers. A line is always one of the question's, never one through points that were cut
// before: so the numbers have a bounded length, however often a polygon is cut.
namespace keikan::oracle {

/// Values in the order in which they come, at addresses that last. Forgetting all of them keeps the memory
/// of the values themselves, so that GMP asks for none when the next pixel's numbers are as long.
template <typename Value>
class Pool {
  public:
    void forget_all() { used_ = 0; }
    Value& next() {
        if (used_ == values_.size()) values_.emplace_back();
        return values_[used_++];
    }
    Value& operator[](std::size_t i) { return values_[i]; }
    std::size_t size() const { return used_; }

  private:
    std::deque<Value> values_;
    std::size_t used_ = 0;
};

struct RationalCorner;

/// a x + b y + c = 0, without a common factor 2.
struct RationalLine {
    mpz_class a, b, c;
    double near_a = 0, near_b = 0, near_c = 0;  ///< in pixels, with a common factor: the largest is at most 1
    const RationalCorner *from = nullptr, *to = nullptr;  ///< two points that it leads through, or none
    std::uint32_t index = 0;
};

/// (x/w, y/w), w > 0.
struct RationalCorner {
    mpz_class x, y, w;
    double near_x = 0, near_y = 0;  ///< in pixels; of a point of the pixel: within 2^-50
    const RationalLine *first = nullptr, *second = nullptr;  ///< two lines that meet there, or none
    std::uint32_t index = 0;
};

/// A line and the direction in which a border runs along it: 1 if the line's positive side is to the left.
struct DirectedLine {
    const RationalLine* line = nullptr;
    int sense = 1;
};

class RationalLines {
  public:
    /// Forgets everything. Requires: every later coordinate, times 2^unit_bits, is whole.
    void start(PixelIndex pixel, int unit_bits);

    /// The corner (0 or 1, 0 or 1) of the pixel, a point of the image, and one given as a fraction. The first
    /// two are one corner where they are one point.
    const RationalCorner* pixel_corner(int x, int y);
    const RationalCorner* corner(Point p);
    const RationalCorner* corner(const RationalPoint& p);

    /// The line through two points, left of p q: one line, whichever way and however often it is asked for.
    /// Requires: different points.
    DirectedLine line_through(const RationalCorner* p, const RationalCorner* q);

    /// a x + b y + c = 0 in pixels. Requires: a or b is not 0.
    const RationalLine* line_of(const mpz_class& a, const mpz_class& b, const mpz_class& c);

    /// Says where two lines meet, which saves finding it: corners of outlines are shorter than crossings.
    void lines_meet_at(const RationalLine* first, const RationalLine* second, const RationalCorner* corner);

    /// Requires: the lines cross at one point of the pixel.
    const RationalCorner* meeting_point(const RationalLine* first, const RationalLine* second);

    /// 1 to the left, 0 on the line, -1 to the right. Requires: a point of the pixel.
    int side(const RationalCorner& point, DirectedLine along);

    /// Whether p q r turns left. Any points.
    bool turns_left(const RationalCorner& p, const RationalCorner& q, const RationalCorner& r);

    int unit_bits() const { return unit_bits_; }
    const RationalCorner& corner_at(std::uint32_t index) { return corners_[index]; }

  private:
    RationalCorner& fresh_corner();
    const RationalLine* finished(RationalLine& line);
    void set_scaled(mpz_class& result, double value, int pixel) const;

    PixelIndex pixel_;
    int unit_bits_ = 0;
    Pool<RationalCorner> corners_;
    Pool<RationalLine> lines_;
    KeyTable corner_of_point_;  ///< by the bits of the doubles
    KeyTable line_of_corners_, corner_of_lines_;
    mpz_class sum_, other_sum_, third_sum_;  ///< kept, so that a side test allocates nothing
};

/// The least n >= 0 for which value * 2^n is whole.
int bits_after_the_point(double value);

/// value * 2^bits. Requires: that it is whole.
mpz_class scaled(double value, int bits);

}  // namespace keikan::oracle
