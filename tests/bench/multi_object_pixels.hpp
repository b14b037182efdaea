// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "keikan/scene/camera.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan::bench {

/// Seconds that VisibleAreas took for each pixel that shows several objects, or an object and the background,
/// in one thread, the pixel's list of faces being ready. Rising.
std::vector<double> seconds_of_multi_object_pixels(const Geometry& geometry, const Camera& camera);

}  // namespace keikan::bench
