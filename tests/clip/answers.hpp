// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

#include "degenerate_pixels.hpp"
#include "keikan/clip/visible_areas.hpp"

namespace keikan::test {

/// A coverage that outlives the next question.
struct Answer {
    std::vector<VisiblePart> parts;
    double background = 0;

    double area(std::uint32_t face) const {
        for (const VisiblePart& part : parts)
            if (part.face == face) return part.area;
        return 0;
    }
    double sum() const {
        double total = background;
        for (const VisiblePart& part : parts) total += part.area;
        return total;
    }
};

inline Answer ask(VisibleAreas& visible_areas, PixelIndex pixel, std::span<const FaceView> faces,
                  Nearness nearness) {
    const PixelCoverage coverage = visible_areas(pixel, faces, nearness);
    return {{coverage.parts.begin(), coverage.parts.end()}, coverage.background};
}

inline Answer ask(VisibleAreas& visible_areas, const PixelCase& pixel_case) {
    const std::vector<FaceView> faces = pixel_case.faces();
    return ask(visible_areas, pixel_case.pixel, faces, pixel_case.nearness());
}

inline Answer ask(const PixelCase& pixel_case) {
    VisibleAreas visible_areas;
    return ask(visible_areas, pixel_case);
}

inline Answer ask(std::vector<Ring> polygons, std::optional<std::vector<DepthPlane>> depth = {}) {
    PixelCase pixel_case;
    pixel_case.polygons = std::move(polygons);
    pixel_case.depth = std::move(depth);
    return ask(pixel_case);
}

inline bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Bit for bit the same, where face i of `a` is called name[i] in `b`.
inline bool same_bits(const Answer& a, const Answer& b, const std::vector<std::uint32_t>& name) {
    if (!same_bits(a.background, b.background) || a.parts.size() != b.parts.size()) return false;
    return std::all_of(a.parts.begin(), a.parts.end(), [&](const VisiblePart& p) {
        return std::any_of(b.parts.begin(), b.parts.end(), [&](const VisiblePart& q) {
            return q.face == name[p.face] && same_bits(p.area, q.area) &&
                   same_bits(p.centroid.x, q.centroid.x) && same_bits(p.centroid.y, q.centroid.y);
        });
    });
}

inline std::vector<std::uint32_t> same_names(std::size_t n) {
    std::vector<std::uint32_t> names(n);
    for (std::size_t i = 0; i < n; ++i) names[i] = static_cast<std::uint32_t>(i);
    return names;
}

inline void shuffle(Dice& dice, std::vector<std::uint32_t>& order) {
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[static_cast<std::size_t>(dice.number(0, static_cast<int>(i) - 1))]);
}

inline const Ring kPixel{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// Calls check(case, family name) for pixels of every family, with and without depth.
template <class Check>
void for_all_families(std::uint64_t seed, int count, Check check) {
    for (const Family& family : families())
        for (const bool with_depth : {false, true}) {
            Dice dice(seed);
            for (int i = 0; i < count; ++i) check(random_pixel(family, dice, with_depth), dice, family.name);
        }
}

}  // namespace keikan::test
