// SPDX-License-Identifier: GPL-3.0-or-later
// The slowest rung and the last word: every step is a Boolean set operation of CGAL on polygons with exact
// coordinates. Nothing here is clever, on purpose.
//
// CGAL 5.5 gives up on some sequences of differences, and throws:
//   - with a violated precondition (Arrangement_on_surface_2.h: number_of_outer_ccbs() == 1) when parts of a
//     set touch at a point: about one pixel in 600 whose corners lie on a coarse grid;
//   - with a violated assertion (Arr_segment_traits_2.h: bool(res)) where the powers of two of coordinates
//   lie
//     so far apart that the product of four of them is no double: two lines that meet are said not to, since
//     Line_2_Line_2.h takes an interval that has overflowed for a number that is not finite, and gives up
//     instead of asking the exact number behind it.
// Such a pixel is decided by a plain arrangement of all segments, CGAL's as well, over fractions without
// intervals before them, which have nothing to overflow.
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/exceptions.h>

#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "exact_areas.hpp"

namespace keikan::oracle {
namespace {

using FilteredKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PlainKernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

/// The question's outlines and regions, in the numbers of either kernel.
template <class Kernel>
struct Regions {
    using Number = typename Kernel::FT;
    using ExactPoint = typename Kernel::Point_2;
    using Polygon = CGAL::Polygon_2<Kernel>;

    static Polygon pixel_square(PixelIndex pixel) {
        const Number x(pixel.x), y(pixel.y), one(1);
        const std::array<ExactPoint, 4> corners = {ExactPoint(x, y), ExactPoint(x + one, y),
                                                   ExactPoint(x + one, y + one), ExactPoint(x, y + one)};
        return Polygon(corners.begin(), corners.end());
    }

    /// The outline as the question defines it: the convex hull of its points; empty if that has no area.
    static Polygon convex_outline(const FaceView& face) {
        std::vector<ExactPoint> points;
        for (const Point& p : face.outline) points.emplace_back(Number(p.x), Number(p.y));
        Polygon hull;
        CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
        return hull.size() >= 3 ? hull : Polygon();
    }

    /// The part of `square` where a x + b y + c > 0, with its border; empty if there is none.
    static Polygon positive_part(const Polygon& square, const Number& a, const Number& b, const Number& c) {
        Polygon part;
        bool has_inside = false;
        for (std::size_t i = 0; i < square.size(); ++i) {
            const ExactPoint& p = square[i];
            const ExactPoint& q = square[(i + 1) % square.size()];
            const Number at_p = a * p.x() + b * p.y() + c;
            const Number at_q = a * q.x() + b * q.y() + c;
            if (at_p >= 0) part.push_back(p);
            has_inside = has_inside || at_p > 0;
            if (at_p * at_q < 0) part.push_back(p + (q - p) * Number(at_p / (at_p - at_q)));
        }
        return has_inside ? part : Polygon();
    }

    /// The part of the pixel where face `other` is nearer than face `face`.
    static Polygon where_nearer(const Polygon& square, std::span<const FaceView> faces, std::size_t other,
                                std::size_t face, Nearness nearness) {
        if (nearness == Nearness::InOrder) return other < face ? square : Polygon();
        const DepthPlane& u = faces[other].depth;
        const DepthPlane& v = faces[face].depth;
        if (u == v) {
            const bool smaller = std::pair(faces[other].id, other) < std::pair(faces[face].id, face);
            return smaller ? square : Polygon();
        }
        return positive_part(square, Number(u.a) - Number(v.a), Number(u.b) - Number(v.b),
                             Number(u.c) - Number(v.c));
    }
};

mpq_class as_mpq(const FilteredKernel::FT& number) {
    return mpq_class(CGAL::exact(number).get_mpq_t());
}
mpq_class as_mpq(const PlainKernel::FT& number) {
    return mpq_class(number.mpq());
}

using PolygonSet = CGAL::Polygon_set_2<FilteredKernel>;

mpq_class exact_area(const PolygonSet& set) {
    std::vector<PolygonSet::Polygon_with_holes_2> parts;
    set.polygons_with_holes(std::back_inserter(parts));
    mpq_class area = 0;
    for (const auto& part : parts) {
        area += as_mpq(part.outer_boundary().area());
        for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) area += as_mpq(hole->area());
    }
    return area;
}

ExactAreas by_boolean_sets(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    using Region = Regions<FilteredKernel>;
    using Polygon = Region::Polygon;
    const Polygon square = Region::pixel_square(pixel);
    std::vector<PolygonSet> in_pixel(faces.size());
    PolygonSet background(square);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Polygon outline = Region::convex_outline(faces[i]);
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
            const Polygon nearer = Region::where_nearer(square, faces, j, i, nearness);
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

using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<PlainKernel>>;
using PlainRegion = Regions<PlainKernel>;

/// Whether the points just left of the middle of p q lie in the convex polygon. A side of the polygon that
/// runs through that middle must run along p q.
bool just_left_is_in(const PlainRegion::Polygon& convex, const PlainRegion::ExactPoint& p,
                     const PlainRegion::ExactPoint& q) {
    if (convex.is_empty()) return false;
    const PlainRegion::ExactPoint middle = CGAL::midpoint(p, q);
    const PlainKernel::Vector_2 left = (q - p).perpendicular(CGAL::COUNTERCLOCKWISE);
    for (auto side = convex.edges_begin(); side != convex.edges_end(); ++side) {
        const CGAL::Orientation turn = CGAL::orientation(side->source(), side->target(), middle);
        if (turn == CGAL::RIGHT_TURN) return false;
        if (turn == CGAL::COLLINEAR && CGAL::orientation(side->to_vector(), left) != CGAL::LEFT_TURN)
            return false;
    }
    return true;
}

mpq_class ring_area(Arrangement::Ccb_halfedge_const_circulator first) {
    PlainRegion::Polygon ring;
    auto side = first;
    do ring.push_back(side->source()->point());
    while (++side != first);
    return as_mpq(ring.area());  // of a ring that touches itself, too
}

bool add_up_to_one(const ExactAreas& exact) {
    mpq_class total = exact.background;
    for (const mpq_class& area : exact.areas) total += area;
    return total == 1;
}

/// CGAL reports a violated precondition on the terminal before it throws; here it only throws.
void quiet_failure(const char*, const char*, const char*, int, const char*) {}

}  // namespace

ExactAreas areas_by_boolean_sets(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    static const auto noisy_failure = CGAL::set_error_handler(quiet_failure);
    static_cast<void>(noisy_failure);
    try {
        ExactAreas result = by_boolean_sets(pixel, faces, nearness);
        if (add_up_to_one(result)) return result;
    } catch (const CGAL::Failure_exception&) {
        // answered below
    }
    return areas_by_arrangement(pixel, faces, nearness);
}

/// All outlines, and the borders of all regions of nearness, cut the pixel into parts; each part is seen
/// whole, by the face nearest in it.
ExactAreas areas_by_arrangement(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    const std::size_t count = faces.size();
    using Polygon = PlainRegion::Polygon;
    const Polygon square = PlainRegion::pixel_square(pixel);
    std::vector<PlainKernel::Segment_2> segments;
    const auto add = [&segments](const Polygon& polygon) {
        segments.insert(segments.end(), polygon.edges_begin(), polygon.edges_end());
    };
    add(square);
    std::vector<Polygon> outlines;
    std::vector<std::vector<Polygon>> nearer_than(count);  // [i][j]: where j is nearer than i
    for (std::size_t i = 0; i < count; ++i) {
        outlines.push_back(PlainRegion::convex_outline(faces[i]));
        add(outlines[i]);
        for (std::size_t j = 0; j < count; ++j) {
            nearer_than[i].push_back(PlainRegion::where_nearer(square, faces, j, i, nearness));
            if (j < i) add(nearer_than[i][j]);
        }
    }
    Arrangement arrangement;
    CGAL::insert(arrangement, segments.begin(), segments.end());

    ExactAreas result{std::vector<mpq_class>(count, 0), 0};
    for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
        if (face->is_unbounded()) continue;
        const auto border = face->outer_ccb();
        const PlainRegion::ExactPoint &p = border->source()->point(), &q = border->target()->point();
        if (!just_left_is_in(square, p, q)) continue;
        mpq_class area = ring_area(border);
        for (auto hole = face->holes_begin(); hole != face->holes_end(); ++hole) area += ring_area(*hole);

        std::optional<std::size_t> seen;
        for (std::size_t i = 0; i < count; ++i)
            if (just_left_is_in(outlines[i], p, q) && (!seen || just_left_is_in(nearer_than[*seen][i], p, q)))
                seen = i;
        (seen ? result.areas[*seen] : result.background) += area;
    }
    return result;
}

}  // namespace keikan::oracle
