// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"

namespace keikan::test {

/// The visible areas exactly, for any exact field `Number` that can be made from a double.
///
/// By another method than the product's: no cells that faces are inserted into, no snapping, no order. Each
/// face on its own: its part in the pixel, less the nearer part of every other face, one convex difference
/// after the other. The background: the pixel, less every face. That everything adds up to 1 is therefore
/// a check of the reference and not built into it.
template <class Number>
class ExactReference {
  public:
    struct Areas {
        std::vector<Number> areas;  ///< parallel to the faces asked about
        Number background = 0;
    };

    static Areas visible_areas(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
        std::vector<Polygon> clipped;
        std::vector<Plane> planes;
        const Polygon square = pixel_square();
        for (const FaceView& face : faces) {
            Polygon local;
            for (const Point p : face.outline)
                local.push_back({Number(p.x) - pixel.x, Number(p.y) - pixel.y});
            clipped.push_back(intersection(hull(std::move(local)), square));
            const Number a(face.depth.a), b(face.depth.b);
            planes.push_back({a, b, Number(face.depth.c) + a * pixel.x + b * pixel.y});
        }
        Areas result;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            std::vector<Polygon> seen{clipped[i]};
            for (std::size_t j = 0; j < faces.size(); ++j) {
                if (j == i || seen.empty()) continue;
                if (nearness == Nearness::InOrder) {
                    if (j < i) subtract(seen, clipped[j]);
                    continue;
                }
                const Plane d{planes[j].a - planes[i].a, planes[j].b - planes[i].b,
                              planes[j].c - planes[i].c};
                if (d.a == 0 && d.b == 0) {
                    if (d.c > 0 || (d.c == 0 && faces[j].id < faces[i].id)) subtract(seen, clipped[j]);
                } else {
                    subtract(seen, part(clipped[j], d, true));
                }
            }
            result.areas.push_back(area(seen));
        }
        std::vector<Polygon> free{square};
        for (const Polygon& polygon : clipped) subtract(free, polygon);
        result.background = area(free);
        return result;
    }

  private:
    struct Vertex {
        Number x, y;
    };
    using Polygon = std::vector<Vertex>;  ///< convex, turning from +x towards +y; empty: no area
    struct Plane {
        Number a, b, c;
        Number at(const Vertex& v) const { return a * v.x + b * v.y + c; }
    };

    static Polygon pixel_square() { return {{0, 0}, {1, 0}, {1, 1}, {0, 1}}; }

    static Number cross(const Vertex& o, const Vertex& p, const Vertex& q) {
        return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
    }

    static Polygon hull(Polygon points) {
        std::sort(points.begin(), points.end(),
                  [](const Vertex& p, const Vertex& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
        Polygon lower, upper;
        const auto extend = [](Polygon& chain, const Vertex& v) {
            while (chain.size() > 1 && cross(chain[chain.size() - 2], chain.back(), v) <= 0) chain.pop_back();
            chain.push_back(v);
        };
        for (const Vertex& v : points) extend(lower, v);
        std::reverse(points.begin(), points.end());
        for (const Vertex& v : points) extend(upper, v);
        if (lower.size() < 2 || upper.size() < 2) return {};
        lower.pop_back(), upper.pop_back();
        lower.insert(lower.end(), upper.begin(), upper.end());
        return lower.size() < 3 ? Polygon{} : lower;
    }

    /// The part of a polygon where the plane is positive, or where it is negative.
    static Polygon part(const Polygon& polygon, const Plane& plane, bool positive) {
        Polygon kept;
        bool has_area = false;
        std::vector<Number> side;
        for (const Vertex& v : polygon) side.push_back(positive ? plane.at(v) : Number(-plane.at(v)));
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::size_t next = (i + 1) % polygon.size();
            const Vertex &p = polygon[i], &q = polygon[next];
            has_area = has_area || side[i] > 0;
            if (side[i] >= 0) kept.push_back(p);
            if ((side[i] > 0 && side[next] < 0) || (side[i] < 0 && side[next] > 0)) {
                const Number t = side[i] / (side[i] - side[next]);
                kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
            }
        }
        return has_area ? kept : Polygon{};
    }

    static Plane left_of(const Vertex& p, const Vertex& q) {
        const Number dx = q.x - p.x, dy = q.y - p.y;
        return {-dy, dx, dy * p.x - dx * p.y};
    }

    static Polygon intersection(Polygon polygon, const Polygon& convex) {
        for (std::size_t i = 0; i < convex.size() && !polygon.empty(); ++i)
            polygon = part(polygon, left_of(convex[i], convex[(i + 1) % convex.size()]), true);
        return convex.empty() ? Polygon{} : polygon;
    }

    static void subtract(std::vector<Polygon>& pieces, const Polygon& convex) {
        if (convex.empty()) return;
        std::vector<Polygon> left;
        for (Polygon& piece : pieces) {
            const std::size_t before = left.size();
            Polygon common = piece;
            for (std::size_t i = 0; i < convex.size() && !common.empty(); ++i) {
                const Plane edge = left_of(convex[i], convex[(i + 1) % convex.size()]);
                Polygon outside = part(common, edge, false);
                if (outside.empty()) continue;
                left.push_back(std::move(outside));
                common = part(common, edge, true);
            }
            if (!common.empty() || piece.empty()) continue;
            left.resize(before);  // nothing in common: leave it whole
            left.push_back(std::move(piece));
        }
        pieces = std::move(left);
    }

    static Number area(const std::vector<Polygon>& pieces) {
        Number twice = 0;
        for (const Polygon& piece : pieces)
            for (std::size_t i = 2; i < piece.size(); ++i) twice += cross(piece[0], piece[i - 1], piece[i]);
        return twice / 2;
    }
};

}  // namespace keikan::test
