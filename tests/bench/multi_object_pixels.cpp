// SPDX-License-Identifier: Apache-2.0
#include "multi_object_pixels.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/image/image.hpp"
#include "keikan/scan/scan_scene.hpp"

namespace keikan::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kPasses = 5;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

bool shows_several_objects(const ScanBand& band, const DividedPixel& pixel) {
    if (pixel.background > 0) return true;
    const auto object = [&](std::uint32_t part) { return band.faces[band.parts[part].face].object; };
    for (std::uint32_t part = pixel.part_begin + 1; part < pixel.part_end; ++part)
        if (object(part) != object(pixel.part_begin)) return true;
    return false;
}

std::vector<PixelIndex> multi_object_pixels(const ProjectedFaces& faces, const Geometry& geometry,
                                            const Camera& camera) {
    std::vector<PixelIndex> found;
    scan_faces(faces, geometry, camera, {}, [&](const ScanBand& band) {
        for (int row = 0; row < band.rows; ++row) {
            const auto r = static_cast<std::size_t>(row);
            for (std::uint32_t i = band.divided_begin[r]; i < band.divided_begin[r + 1]; ++i)
                if (shows_several_objects(band, band.divided[i]))
                    found.push_back({band.divided[i].x, band.first_row + row});
        }
    });
    return found;
}

/// Where a face stands to a pixel: enough to leave out what the scan would leave out as well.
struct Standing {
    bool outside = false;  ///< the pixel is wholly on the outer side of one edge
    bool covers = false;   ///< the pixel is wholly on the inner side of every edge
    double nearest = 0;    ///< largest and smallest w at the pixel's corners
    double farthest = 0;
};

Standing standing(const FaceView& face, PixelIndex pixel) {
    const std::array<Point, 4> corners{Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}};
    const auto local = [&](Point p) { return Point{p.x - pixel.x, p.y - pixel.y}; };
    double area = 0;
    for (std::size_t i = 2; i < face.outline.size(); ++i) {
        const Point a = local(face.outline[0]), b = local(face.outline[i - 1]), c = local(face.outline[i]);
        area += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }
    Standing result{.outside = area == 0, .covers = area != 0, .nearest = 0, .farthest = 0};
    for (std::size_t i = 0; i < face.outline.size(); ++i) {
        const Point a = local(face.outline[i]);
        const Point b = local(face.outline[(i + 1) % face.outline.size()]);
        int inner = 0;
        int outer = 0;
        for (const Point corner : corners) {
            const double side = (b.x - a.x) * (corner.y - a.y) - (b.y - a.y) * (corner.x - a.x);
            inner += side * area >= 0 ? 1 : 0;
            outer += side * area <= 0 ? 1 : 0;
        }
        result.outside = result.outside || (outer == 4 && inner < 4);
        result.covers = result.covers && inner == 4;
    }
    const double w = face.depth.a * pixel.x + face.depth.b * pixel.y + face.depth.c;
    result.nearest = w + std::max(face.depth.a, 0.0) + std::max(face.depth.b, 0.0);
    result.farthest = w + std::min(face.depth.a, 0.0) + std::min(face.depth.b, 0.0);
    return result;
}

/// For each pixel, the faces that can be seen in it, the wholly hidden ones left out.
std::vector<std::vector<std::uint32_t>> candidates(const ProjectedFaces& faces, const Camera& camera,
                                                   const std::vector<PixelIndex>& pixels) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    Image<std::uint32_t> place(camera.size, kNone);
    for (std::size_t i = 0; i < pixels.size(); ++i) place[pixels[i]] = static_cast<std::uint32_t>(i);

    std::vector<std::vector<std::uint32_t>> lists(pixels.size());
    std::vector<double> cover(pixels.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const FaceView face = faces[f];
        Point low = face.outline[0];
        Point high = low;
        for (const Point p : face.outline) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        const auto column = [&](double x) {
            return static_cast<int>(std::clamp(x, 0.0, camera.size.width - 1.0));
        };
        const auto row = [&](double y) {
            return static_cast<int>(std::clamp(y, 0.0, camera.size.height - 1.0));
        };
        for (int y = row(low.y); y <= row(high.y); ++y)
            for (int x = column(low.x); x <= column(high.x); ++x) {
                const std::uint32_t i = place[{x, y}];
                if (i == kNone) continue;
                const Standing at = standing(face, {x, y});
                if (at.outside) continue;
                lists[i].push_back(static_cast<std::uint32_t>(f));
                if (at.covers) cover[i] = std::max(cover[i], at.farthest);
            }
    }
    for (std::size_t i = 0; i < pixels.size(); ++i)
        std::erase_if(lists[i],
                      [&](std::uint32_t f) { return standing(faces[f], pixels[i]).nearest < cover[i]; });
    return lists;
}

}  // namespace

std::vector<double> seconds_of_multi_object_pixels(const Geometry& geometry, const Camera& camera) {
    const ProjectedFaces faces = project_faces(geometry, camera);
    const std::vector<PixelIndex> pixels = multi_object_pixels(faces, geometry, camera);
    const std::vector<std::vector<std::uint32_t>> lists = candidates(faces, camera, pixels);

    VisibleAreas visible_areas;
    std::vector<FaceView> seen;
    // The least of several passes: what the pixel costs when nobody else is given the processor meanwhile.
    std::vector<double> seconds(pixels.size(), std::numeric_limits<double>::infinity());
    for (int pass = 0; pass < kPasses; ++pass)
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            seen.clear();
            for (const std::uint32_t f : lists[i]) seen.push_back(faces[f]);
            const Clock::time_point start = Clock::now();
            visible_areas(pixels[i], seen, Nearness::ByDepth);
            seconds[i] = std::min(seconds[i], seconds_since(start));
        }
    std::sort(seconds.begin(), seconds.end());
    return seconds;
}

}  // namespace keikan::bench
