// SPDX-License-Identifier: Apache-2.0
#include "pixel_painter.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace keikan {

namespace {

/// A region around p that has an area.
void add_point(Point p, WaterRegion& region) {
    const Point tiny[] = {p, {p.x + 0x1p-30, p.y}, {p.x, p.y + 0x1p-30}};
    region.add(tiny);
}

}  // namespace

std::uint64_t PixelPainter::paint(const WaterPixels& all, const WaterPixels::Pixel& pixel, Rgb& colour) {
    samples_of_pixel_ = 0;
    at_ = {pixel.x, pixel.y};
    ++statistics_.pixels;
    if (pixel.water != kNoWater) {
        region_.set_whole();
        colour = water_colour(pixel.water, 1, Rgb{});
    } else {
        paint_divided(all.parts(pixel), colour);
    }
    count_samples(samples_of_pixel_);
    return samples_of_pixel_;
}

void PixelPainter::paint_points(std::span<const WaterPoint> points,
                                std::span<const std::uint16_t> water_of_object, Rgb& colour) {
    bool any = false;
    sampler_.begin_points({points[0].x, points[0].y});
    // Neighbours of one water at once.
    for (std::size_t first = 0; first < points.size();) {
        const std::uint16_t water = water_of_object[points[first].object];
        positions_.clear();
        std::size_t end = first;
        for (; end < points.size() && water_of_object[points[end].object] == water; ++end)
            positions_.push_back(points[end].at);
        if (water != kNoWater) {
            any = true;
            const std::span<const Rgb> colours = sampler_.colours_at(water, positions_);
            for (std::size_t i = first; i < end; ++i)
                colour = colour + static_cast<float>(points[i].weight) * colours[i - first];
        }
        first = end;
    }
    if (!any) return;
    ++statistics_.pixels;
    count_samples(points.size());
}

WaterStatistics PixelPainter::statistics() const {
    WaterStatistics all = statistics_;
    const WaterStatistics& seen = sampler_.statistics();
    all.samples = seen.samples;
    all.face_rays = seen.face_rays;
    all.wave_rays = seen.wave_rays;
    all.wave_steps = seen.wave_steps;
    all.missed = seen.missed;
    return all;
}

void PixelPainter::count_samples(std::uint64_t samples) {
    statistics_.most_samples = std::max(statistics_.most_samples, samples);
    const auto bin = static_cast<std::size_t>(std::bit_width(std::max<std::uint64_t>(samples, 1)) - 1);
    ++statistics_.histogram[std::min(bin, statistics_.histogram.size() - 1)];
}

void PixelPainter::paint_divided(std::span<const WaterPixels::Part> parts, Rgb& colour) {
    // The triangles of one water are one region; with nothing else in the pixel, the whole of it.
    double water_weight = 0;
    for (const WaterPixels::Part& part : parts)
        if (part.water == parts[0].water && part.water != kNoWater) water_weight += part.weight;
    if (water_weight >= 1 - kAreaSumError) {
        region_.set_whole();
        colour = water_colour(parts[0].water, 1, Rgb{});
        return;
    }
    ++statistics_.mixed_pixels;
    if (options_.mixed == MixedPixels::Paper) {
        const auto largest = std::max_element(parts.begin(), parts.end(), [](const auto& p, const auto& q) {
            return std::pair(p.water != kNoWater, p.weight) < std::pair(q.water != kNoWater, q.weight);
        });
        region_.set_whole();
        colour = water_colour(largest->water, 1, Rgb{});
        return;
    }
    paint_regions(parts, colour);
}

void PixelPainter::paint_regions(std::span<const WaterPixels::Part> parts, Rgb& colour) {
    // The faces that are seen hide what is hidden, so they alone divide the pixel as all faces do.
    asked_.clear();
    for (const WaterPixels::Part& part : parts) {
        const auto found = std::lower_bound(faces_.id.begin(), faces_.id.end(), part.face);
        asked_.push_back(faces_[static_cast<std::size_t>(found - faces_.id.begin())]);
    }
    visible_areas_(at_, asked_, Nearness::ByDepth);
    const auto pieces = visible_areas_.pieces();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::uint16_t water = parts[i].water;
        if (water == kNoWater) continue;
        const auto same = [&](const WaterPixels::Part& part) { return part.water == water; };
        if (std::any_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(i), same)) continue;
        double weight = 0;
        for (const WaterPixels::Part& part : parts)
            if (same(part)) weight += part.weight;
        region_.clear();
        for (const VisiblePiece& piece : pieces)
            if (piece.face < parts.size() && same(parts[piece.face])) region_.add(piece.ring);
        // A region that only rounding left is where its centroid is.
        if (region_.empty()) add_point(parts[i].centroid, region_);
        colour = colour + static_cast<float>(weight) * water_colour(water, weight, colour);
    }
}

/// The mean colour of the water over the region; `weight` is its share of the pixel, whose other shares are
/// `base`.
Rgb PixelPainter::water_colour(std::uint16_t water, double weight, Rgb base) {
    const Rgb colour = sampler_.colour(at_, water, region_, weight, base);
    samples_of_pixel_ += sampler_.count();
    return colour;
}

}  // namespace keikan
