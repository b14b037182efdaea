// SPDX-License-Identifier: GPL-3.0-or-later
// The slowest rung and the last word: every step is a Boolean set operation of CGAL on polygons with exact
// coordinates. Nothing here is clever, on purpose.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/convex_hull_2.h>

#include <array>
#include <iterator>
#include <utility>

#include "exact_areas.hpp"

namespace keikan::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactNumber = Kernel::FT;
using ExactPoint = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

Polygon pixel_square(PixelIndex pixel) {
    const ExactNumber x(pixel.x), y(pixel.y);
    const std::array<ExactPoint, 4> corners = {ExactPoint(x, y), ExactPoint(x + 1, y), ExactPoint(x + 1, y + 1),
                                               ExactPoint(x, y + 1)};
    return Polygon(corners.begin(), corners.end());
}

/// The outline as the question defines it: the convex hull of its points; empty if that has no area.
Polygon convex_outline(const FaceView& face) {
    std::vector<ExactPoint> points;
    for (const Point& p : face.outline) points.emplace_back(p.x, p.y);
    Polygon hull;
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    return hull.size() >= 3 ? hull : Polygon();
}

/// The part of `square` where a x + b y + c > 0, with its border; empty if there is none.
Polygon positive_part(const Polygon& square, const ExactNumber& a, const ExactNumber& b, const ExactNumber& c) {
    Polygon part;
    bool has_inside = false;
    for (std::size_t i = 0; i < square.size(); ++i) {
        const ExactPoint& p = square[i];
        const ExactPoint& q = square[(i + 1) % square.size()];
        const ExactNumber at_p = a * p.x() + b * p.y() + c;
        const ExactNumber at_q = a * q.x() + b * q.y() + c;
        if (at_p >= 0) part.push_back(p);
        has_inside = has_inside || at_p > 0;
        if (at_p * at_q < 0) part.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return has_inside ? part : Polygon();
}

/// The part of the pixel where face `other` is nearer than face `face`.
Polygon where_nearer(const Polygon& square, std::span<const FaceView> faces, std::size_t other, std::size_t face,
                     Nearness nearness) {
    if (nearness == Nearness::InOrder) return other < face ? square : Polygon();
    const DepthPlane& u = faces[other].depth;
    const DepthPlane& v = faces[face].depth;
    if (u == v) {
        const bool smaller = std::pair(faces[other].id, other) < std::pair(faces[face].id, face);
        return smaller ? square : Polygon();
    }
    return positive_part(square, ExactNumber(u.a) - v.a, ExactNumber(u.b) - v.b, ExactNumber(u.c) - v.c);
}

CGAL::Gmpq as_gmpq(const ExactNumber& number) { return CGAL::Gmpq(CGAL::exact(number).get_mpq_t()); }

CGAL::Gmpq exact_area(const PolygonSet& set) {
    std::vector<PolygonWithHoles> parts;
    set.polygons_with_holes(std::back_inserter(parts));
    CGAL::Gmpq area = 0;
    for (const PolygonWithHoles& part : parts) {
        area += as_gmpq(part.outer_boundary().area());
        for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) area += as_gmpq(hole->area());
    }
    return area;
}

}  // namespace

ExactAreas areas_by_boolean_sets(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    const Polygon square = pixel_square(pixel);
    std::vector<PolygonSet> in_pixel(faces.size());
    PolygonSet background(square);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Polygon outline = convex_outline(faces[i]);
        if (outline.is_empty()) continue;
        in_pixel[i].insert(outline);
        in_pixel[i].intersection(square);
        background.difference(in_pixel[i]);
    }

    ExactAreas result;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        PolygonSet visible = in_pixel[i];
        for (std::size_t j = 0; j < faces.size() && !visible.is_empty(); ++j) {
            if (j == i || in_pixel[j].is_empty()) continue;
            const Polygon nearer = where_nearer(square, faces, j, i, nearness);
            if (nearer.is_empty()) continue;
            PolygonSet hiding = in_pixel[j];
            hiding.intersection(nearer);
            visible.difference(hiding);
        }
        result.areas.push_back(exact_area(visible));
    }
    result.background = exact_area(background);
    return result;
}

}  // namespace keikan::oracle
