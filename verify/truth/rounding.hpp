// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmpxx.h>

#include <cstdint>
#include <optional>

// The one rounding between an exact coverage and a file.
namespace keikan::truth {

/// The float nearest to `value`, the even one of two equally near. Requires: 0 <= value <= 1.
float nearest_float(const mpq_class& value);

/// The 16-bit code nearest to 65535 * value, the larger one of two equally near. Requires: 0 <= value <= 1.
std::uint16_t nearest_code(const mpq_class& value);
/// The same for a double, as exactly. What lies outside of [0, 1] takes the nearer end.
std::uint16_t nearest_code(double value);

/// A number known to lie in [low, high].
struct Range {
    double low = 0;
    double high = 0;
};

/// The float nearest to every number of the range in [0, 1]; nothing where they differ.
std::optional<float> nearest_float(Range range);
/// Likewise the 16-bit code.
std::optional<std::uint16_t> nearest_code(Range range);

/// Whether a number within `distance` of any of the range could have another code than that one.
bool near_code_boundary(Range range, double distance);

}  // namespace keikan::truth
