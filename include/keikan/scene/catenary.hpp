// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <vector>

namespace keikan {

/// The curve of a uniform wire that hangs between two supports, in the vertical plane through both: at the
/// horizontal distance s from the first support it is height_at(s) above that support,
///
///   height(s) = a (cosh((s - low_m) / a) - cosh(low_m / a)),   a = parameter_m = tension / weight.
///
/// The lowest point low_m of the curve lies outside [0, span_m] where one support is much higher: then the
/// wire rises (or falls) all the way.
struct Catenary {
    double span_m = 1;       ///< horizontal distance of the supports, positive
    double rise_m = 0;       ///< how much higher the second support is
    double parameter_m = 1;  ///< a: horizontal tension [N] over weight [N/m]
    double low_m = 0.5;      ///< s of the lowest point of the curve

    /// Exactly 0 at s = 0 and exactly rise_m at s = span_m, so that a wire meets its supports.
    double height_at(double s) const;
    double slope_at(double s) const;  ///< d height / d s
    double length_m() const;          ///< of the wire between the supports
    /// The largest vertical distance of the wire under the straight line between the supports.
    double sag_m() const;
    /// The largest vertical distance between the wire and its chord over [from_s, to_s].
    double chord_error_m(double from_s, double to_s) const;
};

/// The wire with this horizontal tension and weight.
///
/// Paper:  length L and height h obey sqrt(L^2 - h^2) = 2 a sinh(span / 2a), which puts the lowest point at
///         span/2 - a asinh(h / (2 a sinh(span / 2a))).
/// Errors: InputError unless span, tension and weight are positive and finite, the rise finite, and
///         span / 2a at most kLargestSpanRatio.
Catenary catenary_from_tension(double span_m, double rise_m, double horizontal_tension_n,
                               double weight_n_per_m);

/// The wire that sags by `sag_m`. The sag falls as the parameter grows, so there is exactly one: found by
/// bisection between bounds, guarded secant steps inside.
///
/// Error:  the sag of the result is within kSagError * sag_m of what was asked for.
/// Errors: InputError unless span and sag are positive and finite, and the wire does not need
///         span / 2a above kLargestSpanRatio (a sag of some 60 spans).
Catenary catenary_from_sag(double span_m, double rise_m, double sag_m);

/// sinh and cosh of it stay far from overflow, and no wire hangs so deep.
inline constexpr double kLargestSpanRatio = 6;

/// Relative. Solving to the last bits of the parameter leaves the cancellation in cosh(u) - 1 at u = span/2a,
/// which the half-angle form keeps to a few units in the last place; 1e-12 is that with room for u up to
/// kLargestSpanRatio and steep chords.
inline constexpr double kSagError = 1e-12;

/// Stations 0 = s_0 < s_1 < ... < s_n = span_m, evenly spaced, such that every chord between neighbours is
/// within `chord_error_m` of the wire (measured vertically, so the true distance is smaller still).
///
/// Why: over a segment of length d the vertical error is at most d^2 max|height''| / 8, and
///      height'' = cosh((s - low) / a) / a is largest at an end of the span. (RENDERING: s^2 / 8a.)
/// Requires: chord_error_m > 0.
std::vector<double> catenary_stations(const Catenary& wire, double chord_error_m);

/// The same where the error that may be made changes along the wire, as it does with the distance of the
/// camera: segments are halved until each has chord_error_m(from, to) <= allowed_error_m(from, to).
/// At most 2^12 segments come out, whatever is allowed.
std::vector<double> catenary_stations(
    const Catenary& wire, const std::function<double(double from_s, double to_s)>& allowed_error_m);

}  // namespace keikan
