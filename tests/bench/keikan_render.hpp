// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "keikan/image/image.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_scene.hpp"
#include "keikan/scene/scene.hpp"

namespace keikan::bench {

/// One whole picture from the geometry: project, bin, exact areas, shade. What `keikan render` does between
/// reading the scene and writing the file.
struct RenderTimes {
    ScanStatistics statistics;
    double seconds = 0;
};
RenderTimes render(const Geometry& geometry, const Scene& scene, Image<Rgb>& image);

/// Seconds that VisibleAreas took for each pixel that shows several objects, or an object and the background,
/// in one thread, the pixel's list of faces being ready. Rising.
std::vector<double> seconds_of_multi_object_pixels(const Geometry& geometry, const Camera& camera);

}  // namespace keikan::bench
