// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "keikan/model/pixel_case.hpp"

namespace keikan::test {

/// high + low is within 2^-100 of the exact area.
struct ExactArea {
    double high = 0, low = 0;
};

/// By rational arithmetic (ExactReference): parallel to the polygons, the background at the end. Compiled
/// apart, so that who needs it need not compile rational arithmetic.
std::vector<ExactArea> exact_areas(const PixelCase& pixel_case);

}  // namespace keikan::test
