// SPDX-License-Identifier: Apache-2.0
#include "mirrored_wires.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace keikan {

namespace {

/// The root of the mean square slope of a water, of its waves and all that is smaller.
double slope_deviation(const WaterSurface& water) {
    const double waves = water.waves.slope_deviation();
    return std::sqrt(waves * waves + water.ripple_variance);
}

double depth_of(const Camera& camera, const glm::dvec3& p) {
    return glm::dot(camera.forward, p - camera.position);
}

/// Replaces `corners` by what of the polygon is beyond the near plane; `cut` is memory.
void cut_near(const Camera& camera, std::vector<glm::dvec3>& corners, std::vector<glm::dvec3>& cut) {
    // A little beyond it, so that rounding does not bring a corner before it.
    const double nearest = camera.near_m * (1 + 1e-9);
    cut.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 &p = corners[i], &q = corners[(i + 1) % corners.size()];
        const double from = depth_of(camera, p) - nearest, to = depth_of(camera, q) - nearest;
        if (from >= 0) cut.push_back(p);
        if ((from >= 0) != (to >= 0)) cut.push_back(p + from / (from - to) * (q - p));
    }
    corners.swap(cut);
}

/// How far a slope of `deviation` shifts the mirror image of a point at this height over the water, seen
/// there in the picture, at most [pixels]. A mirror that turns by an angle turns the ray by twice as much; of
/// the way from the eye to the image, the part behind the water turns, which is as long as the heights say.
double shift_px(const Camera& camera, const WaterSurface& water, double deviation, double height_m,
                const ImagePoint& seen) {
    const double eye_m = std::max(camera.position.z - water.level_m, 0.0);
    if (camera.kind == Camera::Kind::Orthographic)
        return 2 * deviation * camera.focal_px * height_m / std::max(-camera.forward.z, 1e-6);
    const double x = std::clamp(seen.x, 0.0, static_cast<double>(camera.size.width)),
                 y = std::clamp(seen.y, 0.0, static_cast<double>(camera.size.height));
    const double u = (x - camera.centre_x) / camera.focal_px, v = (y - camera.centre_y) / camera.focal_px;
    return 2 * deviation * camera.focal_px * (1 + u * u + v * v) * height_m / (height_m + eye_m);
}

/// The least width of the polygon's bounding boxes along its edges: 0 for a line.
double width_of(std::span<const Point> outline) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point p = outline[i], q = outline[(i + 1) % outline.size()];
        const double length = std::hypot(q.x - p.x, q.y - p.y);
        if (!(length > 0)) continue;
        double from = 0, to = 0;
        for (const Point r : outline) {
            const double across = ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / length;
            from = std::min(from, across);
            to = std::max(to, across);
        }
        least = std::min(least, to - from);
    }
    return std::isfinite(least) ? least : 0;
}

}  // namespace

bool MirroredWires::Strip::may_meet(PixelIndex pixel) const {
    for (std::size_t i = 0; i < count; ++i) {
        // The pixel's corner that is farthest inside.
        const double x = pixel.x + (edges[i].x < 0 ? 1 : 0), y = pixel.y + (edges[i].y < 0 ? 1 : 0);
        if (edges[i].x * x + edges[i].y * y > edges[i].at) return false;
    }
    return true;
}

MirroredWires::MirroredWires(const Scene& scene, const Geometry& geometry) : size_(scene.camera.size) {
    for (std::size_t w = 0; w < scene.water.size(); ++w)
        if (scene.water[w]) add_water(scene, geometry, static_cast<std::uint16_t>(w));
    std::sort(entries_.begin(), entries_.end(), [](const Entry& p, const Entry& q) {
        return p.pixel != q.pixel ? p.pixel < q.pixel : p.strip < q.strip;
    });
}

void MirroredWires::add_water(const Scene& scene, const Geometry& geometry, std::uint16_t number) {
    const Camera& camera = scene.camera;
    const WaterSurface& water = *scene.water[number];
    const double deviation = kSlopes * slope_deviation(water);
    std::vector<glm::dvec3> corners, memory;
    std::vector<Point> outline;
    for (const Object& object : geometry.objects) {
        if (object.kind != ObjectKind::Conductor) continue;
        for (std::size_t f = 0; f < object.mesh.face_count(); ++f) {
            corners.clear();
            double highest = 0;
            for (const std::uint32_t corner : object.mesh.face(f)) {
                const glm::dvec3& p = object.mesh.positions[corner];
                highest = std::max(highest, p.z - water.level_m);
                corners.push_back({p.x, p.y, 2 * water.level_m - p.z});
            }
            if (!(highest > 0)) continue;
            cut_near(camera, corners, memory);
            outline.clear();
            double shift = 0;
            for (const glm::dvec3& p : corners) {
                const std::optional<ImagePoint> seen = camera.image_point(p);
                if (!seen) continue;
                outline.push_back({seen->x, seen->y});
                shift = std::max(shift, shift_px(camera, water, deviation, highest, *seen));
            }
            if (outline.size() < 2 || shift > kWidest || width_of(outline) >= kThin) continue;
            add_strip(outline, std::max(shift, kLeastMargin), number);
        }
    }
}

void MirroredWires::add_strip(std::span<const Point> outline, double margin, std::uint16_t water) {
    double left = outline[0].x, right = left, top = outline[0].y, bottom = top;
    for (const Point p : outline) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    Strip strip;
    strip.water = water;
    const auto add_edge = [&](double x, double y, double at) {
        if (strip.count < Strip::kMostEdges) strip.edges[strip.count++] = {x, y, at + margin};
    };
    // Its bounding box first: pointed corners would reach far out.
    add_edge(-1, 0, -left), add_edge(1, 0, right), add_edge(0, -1, -top), add_edge(0, 1, bottom);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point p = outline[i], q = outline[(i + 1) % outline.size()];
        const double length = std::hypot(q.x - p.x, q.y - p.y);
        if (!(length > 0)) continue;
        // Of either orientation: the side on which all corners are, if there is one.
        const double x = (q.y - p.y) / length, y = (p.x - q.x) / length;
        double low = 0, high = 0;
        for (const Point r : outline) {
            const double away = x * (r.x - p.x) + y * (r.y - p.y);
            low = std::min(low, away);
            high = std::max(high, away);
        }
        add_edge(x, y, x * p.x + y * p.y + high);
        add_edge(-x, -y, -(x * p.x + y * p.y) - low);
    }
    const auto index = static_cast<std::uint32_t>(strips_.size());
    const auto within = [](double at, int end) {
        return static_cast<int>(std::clamp(std::floor(at), -1.0, static_cast<double>(end)));
    };
    bool any = false;
    for (int y = std::max(0, within(top - margin, size_.height));
         y <= std::min(size_.height - 1, within(bottom + margin, size_.height)); ++y)
        for (int x = std::max(0, within(left - margin, size_.width));
             x <= std::min(size_.width - 1, within(right + margin, size_.width)); ++x)
            if (strip.may_meet({x, y})) {
                entries_.push_back({static_cast<std::uint32_t>(y * size_.width + x), index});
                any = true;
            }
    if (any) strips_.push_back(strip);
}

void MirroredWires::at(PixelIndex pixel, std::uint16_t water, std::vector<const Strip*>& strips) const {
    strips.clear();
    if (entries_.empty()) return;
    const auto number = static_cast<std::uint32_t>(pixel.y * size_.width + pixel.x);
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), number,
                                  [](const Entry& e, std::uint32_t p) { return e.pixel < p; });
    for (; entry != entries_.end() && entry->pixel == number; ++entry)
        if (strips_[entry->strip].water == water) strips.push_back(&strips_[entry->strip]);
}

}  // namespace keikan
