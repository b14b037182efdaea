// SPDX-License-Identifier: Apache-2.0
#include "water_pixels.hpp"

#include <algorithm>

namespace keikan {

bool has_water_surfaces(const Scene& scene) {
    return std::any_of(scene.water.begin(), scene.water.end(),
                       [](const auto& water) { return water.has_value(); });
}

std::vector<std::uint16_t> water_of_objects(const Scene& scene, const Geometry& geometry) {
    std::vector<std::uint16_t> water_of(geometry.objects.size(), kNoWater);
    std::uint16_t next = 0;
    for (std::size_t o = 0; o < geometry.objects.size(); ++o) {
        if (geometry.objects[o].kind != ObjectKind::Water) continue;
        if (next < scene.water.size() && scene.water[next]) water_of[o] = next;
        ++next;
    }
    return water_of;
}

void WaterPixels::add_divided(int x, int y, std::span<const SeenPart> parts,
                              std::span<const SeenFace> faces) {
    if (by_points_) return;
    const auto begin = static_cast<std::uint32_t>(parts_.size());
    for (const SeenPart& part : parts) {
        const SeenFace& face = faces[part.face];
        parts_.push_back({face.id,
                          water_of(face),
                          {static_cast<double>(part.x), static_cast<double>(part.y)},
                          part.weight});
    }
    pixels_.push_back({x, y, kNoWater, begin, static_cast<std::uint32_t>(parts_.size())});
}

}  // namespace keikan
