// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>

#include "keikan/model/pixel_case.hpp"

namespace keikan::fuzz {

/// Bits that write `value` down: from its first to its last binary digit, and the zeros between the point and
/// its first digit where it is less than 1. 0 for 0, 1 for 1 and 2, 3 for 0.625, 4 for 0.0625.
int bits_of(double value);

/// A case as small as single steps make it that `still_fails`: with fewer polygons, without depth planes, in
/// pixel (0, 0), with fewer corners, with coordinates and planes of fewer bits, in this order of importance.
///
/// Properties: (1) `still_fails` holds for the result, and for every case on the way to it.
///             (2) Every polygon asked about is convex by exact signs, so the result is a valid pixel case.
///             (3) The result depends on `failing` and on the answers alone.
/// Requires:   `still_fails(failing)`; the id and the stated answers are dropped.
/// Cost:       at most `most_questions` calls.
PixelCase shrunk(const PixelCase& failing, const std::function<bool(const PixelCase&)>& still_fails,
                 std::size_t most_questions = 4000);

}  // namespace keikan::fuzz
