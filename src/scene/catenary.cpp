// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/catenary.hpp"

#include <algorithm>
#include <cmath>

#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

/// sinh(x) / x, 1 at 0.
double sinhc(double x) {
    return x == 0 ? 1 : std::sinh(x) / x;
}

void require_supports(double span_m, double rise_m) {
    if (!(span_m > 0) || !std::isfinite(span_m))
        throw InputError("a wire needs supports that stand apart, the span is not positive");
    if (!std::isfinite(rise_m)) throw InputError("the height between a wire's supports is not finite");
}

/// The wire through both supports for u = span / 2a.
Catenary catenary_from_ratio(double span_m, double rise_m, double u) {
    const double a = span_m / (2 * u);
    return {span_m, rise_m, a, span_m / 2 - a * std::asinh(rise_m / (2 * a * std::sinh(u)))};
}

}  // namespace

double Catenary::height_at(double s) const {
    if (s == span_m) return rise_m;
    // cosh A - cosh B as a product: no cancellation where the wire is nearly straight.
    const double a = parameter_m;
    return 2 * a * std::sinh((s - 2 * low_m) / (2 * a)) * std::sinh(s / (2 * a));
}

double Catenary::slope_at(double s) const {
    return std::sinh((s - low_m) / parameter_m);
}

double Catenary::length_m() const {
    const double chordless = 2 * parameter_m * std::sinh(span_m / (2 * parameter_m));
    return std::hypot(chordless, rise_m);
}

double Catenary::sag_m() const {
    return chord_error_m(0, span_m);
}

double Catenary::chord_error_m(double from_s, double to_s) const {
    // In units of a, from the middle of the chord: with q the middle's distance from the lowest point, v half
    // the chord's width, the chord is above the wire by
    //   cosh q (cosh v - cosh t) + t sinh q (sinhc v - sinhc t)   at t,
    // and most where the wire is parallel to it: sinh(q + t) = sinh q sinhc v.
    const double q = ((from_s + to_s) / 2 - low_m) / parameter_m;
    const double v = (to_s - from_s) / (2 * parameter_m);
    const double t = std::asinh(std::sinh(q) * sinhc(v)) - q;
    const double bow = 2 * std::cosh(q) * std::sinh((v + t) / 2) * std::sinh((v - t) / 2);
    const double tilt = t * std::sinh(q) * (sinhc(v) - sinhc(t));
    return parameter_m * (bow + tilt);
}

Catenary catenary_from_tension(double span_m, double rise_m, double horizontal_tension_n,
                               double weight_n_per_m) {
    require_supports(span_m, rise_m);
    if (!(horizontal_tension_n > 0) || !std::isfinite(horizontal_tension_n))
        throw InputError("a wire's horizontal tension must be positive");
    if (!(weight_n_per_m > 0) || !std::isfinite(weight_n_per_m))
        throw InputError("a wire's weight must be positive");
    const double u = span_m * weight_n_per_m / (2 * horizontal_tension_n);
    if (!(u <= kLargestSpanRatio))
        throw InputError("the wire is far too slack: its tension must be raised or the span shortened");
    return catenary_from_ratio(span_m, rise_m, u);
}

Catenary catenary_from_sag(double span_m, double rise_m, double sag_m) {
    require_supports(span_m, rise_m);
    if (!(sag_m > 0) || !std::isfinite(sag_m)) throw InputError("a wire's sag must be positive");
    const auto excess = [&](double u) { return catenary_from_ratio(span_m, rise_m, u).sag_m() - sag_m; };

    // The parabola sags by (span u / 4) / cos(chord); a catenary by more, so the root lies below its u.
    double high = 4 * sag_m / std::hypot(span_m, rise_m);
    double low = std::min(high, kLargestSpanRatio);
    high = low;
    double above = excess(high);
    while (above < 0) {  // rounding, or a sag beyond all reason
        if (high >= kLargestSpanRatio) throw InputError("the sag is too large for the span");
        high = std::min(2 * high, kLargestSpanRatio);
        above = excess(high);
    }
    double below = excess(low);
    while (below > 0) below = excess(low /= 2);

    // Secant steps; bisection whenever one fails to halve the bracket. Ends when no number lies between.
    while (true) {
        const double middle = low + (high - low) / 2;
        if (!(low < middle && middle < high) || above == 0 || below == 0) break;
        double u = high - above * ((high - low) / (above - below));
        for (const bool secant : {true, false}) {
            if (!secant) u = low + (high - low) / 2;
            if (!(low < u && u < high)) continue;
            const double value = excess(u);
            (value > 0 ? high : low) = u;
            (value > 0 ? above : below) = value;
        }
    }
    return catenary_from_ratio(span_m, rise_m, std::abs(below) < std::abs(above) ? low : high);
}

std::vector<double> catenary_stations(const Catenary& wire, double chord_error_m) {
    KEIKAN_CHECK(chord_error_m > 0, "a chord error of " << chord_error_m << " m cannot be kept");
    const double a = wire.parameter_m;
    const double far_end = std::max(std::abs(wire.low_m), std::abs(wire.span_m - wire.low_m));
    const double step = std::sqrt(8 * a * chord_error_m / std::cosh(far_end / a));
    const double wanted = std::min(std::ceil(wire.span_m / step), 4096.0);
    const auto count = static_cast<std::size_t>(std::max(wanted, 1.0));
    std::vector<double> stations(count + 1);
    for (std::size_t i = 0; i < count; ++i)
        stations[i] = wire.span_m * static_cast<double>(i) / static_cast<double>(count);
    stations[count] = wire.span_m;
    return stations;
}

std::vector<double> catenary_stations(
    const Catenary& wire, const std::function<double(double from_s, double to_s)>& allowed_error_m) {
    constexpr int kDeepest = 12;
    std::vector<double> stations{0};
    const auto divide = [&](const auto& self, double from, double to, int depth) -> void {
        if (depth < kDeepest && wire.chord_error_m(from, to) > allowed_error_m(from, to)) {
            const double middle = from + (to - from) / 2;
            self(self, from, middle, depth + 1);
            self(self, middle, to, depth + 1);
        } else {
            stations.push_back(to);
        }
    };
    divide(divide, 0, wire.span_m, 0);
    return stations;
}

}  // namespace keikan
