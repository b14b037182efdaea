// SPDX-License-Identifier: Apache-2.0
// Two faces in one pixel: a near triangle over half of it, a far square over all of it.
#include <cmath>
#include <cstdio>
#include <keikan/clip/visible_areas.hpp>
#include <vector>

int main() {
    const keikan::Ring triangle{{0, 0}, {1, 0}, {0, 1}};
    const keikan::Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<keikan::FaceView> faces{{0, triangle, {}}, {1, square, {}}};

    keikan::VisibleAreas visible_areas;
    const keikan::PixelCoverage seen = visible_areas({0, 0}, faces, keikan::Nearness::InOrder);
    for (const keikan::VisiblePart& part : seen.parts) std::printf("face %u: %.17g\n", part.face, part.area);

    // Halves are doubles: nothing is lost here.
    const bool right = seen.parts.size() == 2 && seen.parts[0].area == 0.5 && seen.parts[1].area == 0.5;
    return right && std::abs(seen.background) <= keikan::kVisibleAreaError ? 0 : 1;
}
