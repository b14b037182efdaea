// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "double_double.hpp"
#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"
#include "keikan/model/point.hpp"

namespace keikan::clip {

/// A rectangle of the pixel, pixel-local.
struct Box {
    double min_x = 0, min_y = 0, max_x = 1, max_y = 1;
};

/// A depth plane relative to one pixel: w = a x + b y + c in pixel-local coordinates.
struct LocalPlane {
    double a = 0, b = 0;
    DoubleDouble c;      ///< c + a px + b py of `image`; c.hi is the exact sum, rounded
    double c_error = 0;  ///< how far c may be from it
    DepthPlane image;    ///< as given
};

LocalPlane local_plane(PixelIndex pixel, const DepthPlane& plane);

/// A value and how far it may be from the true one.
struct Bounded {
    double value = 0;
    double error = 0;
    bool certainly_positive() const { return value > error; }
    bool certainly_negative() const { return value < -error; }
};

/// The difference of two depth planes: positive where the first is nearer. The coefficients are subtracted
/// before anything is evaluated, so nearly equal planes keep all their bits.
class NearnessDifference {
  public:
    /// Rough: good enough to decide most pairs, with a bound that says when not.
    static NearnessDifference rough(const LocalPlane& first, const LocalPlane& second);
    /// The slopes are exact; the constant is off by at most 2^-80 of all three coefficients together, and
    /// exact in its sign where the slopes are 0.
    static NearnessDifference exact(PixelIndex pixel, const LocalPlane& first, const LocalPlane& second);

    /// Equal everywhere. Only of an exact difference.
    bool is_zero() const { return a_.hi == 0 && b_.hi == 0 && c_.hi == 0; }

    /// The largest and the smallest value in a box.
    Bounded largest(const Box& box) const;
    Bounded smallest(const Box& box) const;

    /// The value at a point, off by at most half an ulp and 2^-79 of the terms' sizes.
    double at(Point p) const;

    /// The value at a point, off by at most error().
    double roughly_at(Point p) const { return (a_.hi * p.x + b_.hi * p.y) + c_.hi; }
    double error() const { return error_; }

    /// Values no larger than this belong to points within one step of the 2^-53 grid from the line.
    double on_line() const;

  private:
    DoubleDouble a_, b_, c_;
    double error_ = 0;
};

/// The line where two faces are equally near, as a cut (split.hpp): inside, the first is nearer.
struct DepthCut {
    explicit DepthCut(const NearnessDifference& d) : difference(d), on_line(d.on_line()) {}
    const NearnessDifference& difference;
    double on_line;
    double side(Point p) const { return difference.at(p); }
    Point weld(Point p) const { return p; }
};

}  // namespace keikan::clip
