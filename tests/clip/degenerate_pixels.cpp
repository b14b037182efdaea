// SPDX-License-Identifier: Apache-2.0
#include "degenerate_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keikan::test {
namespace {

double step_ulps(double v, int steps) {
    for (; steps > 0; --steps) v = std::nextafter(v, HUGE_VAL);
    for (; steps < 0; ++steps) v = std::nextafter(v, -HUGE_VAL);
    return v;
}

Point nudged(Dice& dice, Point p, int most) {
    return {step_ulps(p.x, dice.number(-most, most)), step_ulps(p.y, dice.number(-most, most))};
}

Point point_near_pixel(Dice& dice) {
    return {dice.between(-0.5, 1.5), dice.between(-0.5, 1.5)};
}

/// Corners of an ellipse: convex up to rounding.
Ring round_polygon(Dice& dice, Point centre, double radius_x, double radius_y, int corners) {
    Ring ring;
    const double start = dice.between(0, 7), turn = dice.between(0, 7);
    for (int i = 0; i < corners; ++i) {
        const double angle = start + (i + dice.between(0, 0.8)) * 2 * std::numbers::pi / corners;
        const double u = radius_x * std::cos(angle), v = radius_y * std::sin(angle);
        ring.push_back({centre.x + u * std::cos(turn) - v * std::sin(turn),
                        centre.y + u * std::sin(turn) + v * std::cos(turn)});
    }
    return ring;
}

Ring strip(Point from, Point to, double width) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    const double nx = -dy / length * width, ny = dx / length * width;
    return {from, to, {to.x + nx, to.y + ny}, {from.x + nx, from.y + ny}};
}

Ring random_ring(Dice& dice) {
    return round_polygon(dice, point_near_pixel(dice), dice.between(0.1, 1.5), dice.between(0.1, 1.5),
                         dice.number(3, 7));
}

void random(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(2, 8); n > 0; --n) out.push_back(random_ring(dice));
}

void on_grid(Dice& dice, std::vector<Ring>& out, int cells) {
    for (int n = dice.number(2, 8); n > 0; --n) {
        Ring ring;
        for (int k = dice.number(3, 5); k > 0; --k)
            ring.push_back(
                {dice.number(-1, cells + 1) / double(cells), dice.number(-1, cells + 1) / double(cells)});
        out.push_back(ring);
    }
}
void grid_of_eighths(Dice& dice, std::vector<Ring>& out) {
    on_grid(dice, out, 8);
}
void grid_of_quarters(Dice& dice, std::vector<Ring>& out) {
    on_grid(dice, out, 4);
}

void fan(Dice& dice, std::vector<Ring>& out) {
    const Point hub =
        dice.one_in(3) ? Point{double(dice.number(0, 1)), dice.unit()} : Point{dice.unit(), dice.unit()};
    const int n = dice.number(3, 8);
    std::vector<Point> rim;
    for (int i = 0; i < n; ++i) {
        const double angle = (i + dice.between(0, 0.5)) * 2 * std::numbers::pi / n,
                     r = dice.between(0.1, 1.5);
        rim.push_back({hub.x + r * std::cos(angle), hub.y + r * std::sin(angle)});
    }
    for (int i = 0; i < n; ++i)
        out.push_back({hub, rim[std::size_t(i)], rim[std::size_t((i + dice.number(1, 2)) % n)]});
}

void mesh_layers(Dice& dice, std::vector<Ring>& out) {
    Point at[9];
    for (int i = 0; i < 9; ++i)
        at[i] = {(i % 3) * 0.6 - 0.1 + dice.between(-0.15, 0.15),
                 (i / 3) * 0.6 - 0.1 + dice.between(-0.15, 0.15)};
    for (int layer = 0; layer < 2; ++layer)
        for (int cell = 0; cell < 4; ++cell) {
            const int a = cell % 2 + 3 * (cell / 2), b = a + 1, c = a + 4, d = a + 3;
            if (layer == 0)
                out.push_back({at[a], at[b], at[c]});
            else
                out.push_back({at[d], at[a], at[b]});
        }
}

void t_junctions(Dice& dice, std::vector<Ring>& out, bool exact) {
    const auto grid = [&](double v) { return exact ? std::round(v * 64) / 64 : v; };
    const Point a{grid(dice.between(-0.5, 0.5)), grid(dice.between(-0.5, 1.5))};
    const Point b{a.x + grid(dice.between(0.5, 1)), a.y + grid(dice.between(-1, 1))};
    const auto along = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
    out.push_back({a, b, point_near_pixel(dice)});
    const int n = dice.number(2, 4);
    for (int i = 0; i < n; ++i) out.push_back({along(i / 4.0), along((i + 1) / 4.0), point_near_pixel(dice)});
    for (int i = 0; i < 2; ++i)
        out.push_back({along(dice.number(0, 8) / 8.0), point_near_pixel(dice), point_near_pixel(dice)});
}
void t_junctions_exact(Dice& dice, std::vector<Ring>& out) {
    t_junctions(dice, out, true);
}
void t_junctions_rounded(Dice& dice, std::vector<Ring>& out) {
    t_junctions(dice, out, false);
}

void slivers(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(2, 7); n > 0; --n)
        out.push_back(
            strip(point_near_pixel(dice), point_near_pixel(dice), std::pow(10, -dice.between(3, 9))));
    out.push_back(random_ring(dice));
}

void near_parallel(Dice& dice, std::vector<Ring>& out) {
    const Point from = point_near_pixel(dice), to = point_near_pixel(dice);
    for (int n = dice.number(2, 8); n > 0; --n) {
        const double tilt = std::pow(10, -dice.between(4, 15));
        const Point a{from.x + tilt * dice.between(-1, 1), from.y + tilt * dice.between(-1, 1)};
        const Point b{to.x + tilt * dice.between(-1, 1), to.y + tilt * dice.between(-1, 1)};
        if (dice.one_in(3))
            out.push_back({a, b, {a.x + tilt, b.y + tilt}});
        else
            out.push_back({a, b, point_near_pixel(dice)});
    }
}

void collinear_overlap(Dice& dice, std::vector<Ring>& out) {
    const Point a = point_near_pixel(dice), b = point_near_pixel(dice);
    const auto along = [&](int eighths) {
        return Point{a.x + eighths / 8.0 * (b.x - a.x), a.y + eighths / 8.0 * (b.y - a.y)};
    };
    for (int n = dice.number(2, 8); n > 0; --n) {
        const int s = dice.number(-2, 6);
        out.push_back({along(s), along(s + dice.number(1, 6)), point_near_pixel(dice)});
    }
}

void ulp_twins(Dice& dice, std::vector<Ring>& out) {
    const Ring ring =
        dice.one_in(2) ? random_ring(dice) : Ring{{0.125, 0.125}, {0.875, 0.25}, {0.75, 0.75}, {0.25, 0.875}};
    for (int n = dice.number(3, 8); n > 0; --n) {
        Ring twin;
        for (const Point p : ring) twin.push_back(nudged(dice, p, 2));
        if (dice.one_in(3)) twin.push_back(nudged(dice, twin.front(), 1));
        out.push_back(twin);
    }
}

void nested(Dice& dice, std::vector<Ring>& out) {
    const Point centre{dice.unit(), dice.unit()};
    for (int n = dice.number(2, 8); n > 0; --n) {
        const double r = dice.number(1, 8) / 8.0;
        out.push_back({{centre.x - r, centre.y - r},
                       {centre.x + r, centre.y - r},
                       {centre.x + r, centre.y + r},
                       {centre.x - r, centre.y + r}});
        if (dice.one_in(2)) out.back() = round_polygon(dice, centre, r, r, 5);
    }
}

void border_and_corners(Dice& dice, std::vector<Ring>& out) {
    const auto coordinate = [&] {
        const double places[] = {
            0, 1, 0.5, step_ulps(0, 1), step_ulps(1, 1), step_ulps(1, -1), -1e-17, 1e-17, -0.25, 1.25};
        return dice.one_in(3) ? dice.between(-0.2, 1.2) : places[dice.number(0, 9)];
    };
    for (int n = dice.number(2, 8); n > 0; --n) {
        Ring ring;
        for (int k = dice.number(3, 5); k > 0; --k) ring.push_back({coordinate(), coordinate()});
        out.push_back(ring);
    }
}

void identical(Dice& dice, std::vector<Ring>& out) {
    const Ring ring = random_ring(dice);
    for (int n = dice.number(2, 6); n > 0; --n) {
        out.push_back(ring);
        std::rotate(out.back().begin(), out.back().begin() + dice.number(0, 2), out.back().end());
        if (dice.one_in(2)) std::reverse(out.back().begin(), out.back().end());
    }
    out.push_back(random_ring(dice));
}

void touching_from_inside(Dice& dice, std::vector<Ring>& out) {
    const Ring outer{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int n = dice.number(2, 6); n > 0; --n) {
        Ring inner;
        for (const Point p : outer) {
            const std::size_t i = inner.size();
            const Point q = outer[(i + 1) % 4];
            const double t = dice.number(0, 8) / 8.0;
            inner.push_back(dice.one_in(3) ? Point{dice.unit(), dice.unit()}
                                           : Point{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
        if (dice.one_in(2)) inner.pop_back();
        out.push_back(inner);
    }
    out.push_back(outer);
}

void notches(Dice& dice, std::vector<Ring>& out) {
    const Point tip{dice.number(1, 7) / 8.0, dice.number(1, 7) / 8.0};
    out.push_back({{0, 0}, tip, {0, 1}});
    out.push_back({{0, 0}, {1, 0}, tip});
    out.push_back({{1, 0}, {1, 1}, tip});
    if (dice.one_in(2)) out.push_back({{0, 1}, tip, {1, 1}});
    out.push_back({nudged(dice, tip, 1), {0, 0}, {1, dice.unit()}});
    out.push_back(random_ring(dice));
}

void duplicates(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(2, 8); n > 0; --n) {
        Ring ring;
        for (const Point p : random_ring(dice))
            for (int k = dice.number(1, 3); k > 0; --k)
                ring.push_back(dice.one_in(4) ? nudged(dice, p, 1) : p);
        out.push_back(ring);
    }
}

void tiny_numbers(Dice& dice, std::vector<Ring>& out) {
    const auto coordinate = [&] {
        const double places[] = {0, 5e-324, -5e-324, 1e-300, -1e-300, 1e-160, 1e-17, 1, 0.5, -1, 2, 0.25};
        return dice.one_in(4) ? dice.unit() : places[dice.number(0, 11)];
    };
    for (int n = dice.number(2, 8); n > 0; --n) {
        Ring ring;
        for (int k = dice.number(3, 4); k > 0; --k) ring.push_back({coordinate(), coordinate()});
        out.push_back(ring);
    }
}

/// Edges through the pixel whose ends are 1e2 to 1e6 pixels away.
void huge(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(2, 8); n > 0; --n) {
        const double extent = std::pow(10, dice.between(2, 6)), angle = dice.between(0, 7);
        const Point through{dice.unit(), dice.unit()};
        const double dx = extent * std::cos(angle), dy = extent * std::sin(angle);
        const Point a{through.x - dx * dice.unit(), through.y - dy * dice.unit()};
        const Point b{through.x + dx, through.y + dy};
        const double side = dice.one_in(2) ? extent : dice.between(0.01, 2);
        out.push_back({a, b, {b.x - side * std::sin(angle), b.y + side * std::cos(angle)}});
        if (dice.one_in(2))
            out.back().push_back({a.x - side * std::sin(angle), a.y + side * std::cos(angle)});
    }
}

/// Beyond what an image holds: the double-double crossings give way to exact sums.
void enormous(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(2, 6); n > 0; --n) {
        const double extent = std::ldexp(1, dice.number(20, dice.one_in(4) ? 900 : 90));
        Ring ring = {{dice.unit(), dice.unit()}};
        for (int k = dice.number(2, 4); k > 0; --k)
            ring.push_back({extent * dice.between(-1, 1), extent * dice.between(-1, 1)});
        if (dice.one_in(2)) ring[0] = {extent * dice.between(-1, 1), extent * dice.between(-1, 1)};
        out.push_back(ring);
    }
}

void wires(Dice& dice, std::vector<Ring>& out) {
    const double slope = dice.between(-0.3, 0.3);
    for (int n = dice.number(2, 7); n > 0; --n) {
        const double y = dice.unit(), tilt = slope + dice.between(-1e-3, 1e-3);
        out.push_back(
            strip({-dice.between(0, 50), y}, {1 + dice.between(0, 50), y + tilt}, dice.between(1e-3, 0.2)));
    }
    out.push_back({{-3, -2}, {4, -2}, {4, 3}, {-3, 3}});
}

/// Seen edge-on: quadrilaterals that rounding folded or made concave.
void edge_on(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(2, 8); n > 0; --n) {
        const Point a = point_near_pixel(dice), b = point_near_pixel(dice);
        Ring ring;
        for (int k = 0; k < 4; ++k) {
            const double t = dice.unit();
            ring.push_back(nudged(dice, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, 3));
        }
        if (dice.one_in(3)) ring.push_back(point_near_pixel(dice));
        out.push_back(ring);
    }
}

void whole_pixels(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(1, 3); n > 0; --n)
        out.push_back(
            round_polygon(dice, {0.5, 0.5}, dice.between(1, 9), dice.between(1, 9), dice.number(3, 6)));
    out.push_back({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    for (int n = dice.number(1, 4); n > 0; --n) out.push_back(random_ring(dice));
}

/// Short edges on a circle: angles between neighbours close to a straight line.
void many_corners(Dice& dice, std::vector<Ring>& out) {
    for (int n = dice.number(2, 6); n > 0; --n)
        out.push_back(round_polygon(dice, {dice.unit(), dice.unit()}, dice.between(0.2, 1),
                                    dice.between(0.2, 1), dice.number(12, 40)));
}

/// Corners in a spot of 1e-15 that lies on or near other faces' edges.
void tiny_faces(Dice& dice, std::vector<Ring>& out) {
    const Point at{dice.unit(), dice.unit()};
    for (int n = dice.number(1, 4); n > 0; --n)
        out.push_back(round_polygon(dice, at, std::pow(10, -dice.between(6, 16)),
                                    std::pow(10, -dice.between(6, 16)), 4));
    for (int n = dice.number(1, 4); n > 0; --n)
        out.push_back({at, point_near_pixel(dice), point_near_pixel(dice)});
}

void lattice(Dice& dice, std::vector<Ring>& out) {
    for (int n = 8; n > 0; --n) {
        const bool rising = dice.one_in(2);
        const double offset = dice.between(-0.5, 1);
        const Point a{offset, -0.2}, b{offset + (rising ? 0.9 : -0.9) * dice.between(0.8, 1.2), 1.3};
        out.push_back(strip(a, b, dice.between(0.01, 0.2)));
    }
}

void crowd(Dice& dice, std::vector<Ring>& out) {
    for (int n = 32; n > 0; --n) {
        if (dice.one_in(3))
            out.push_back(strip(point_near_pixel(dice), point_near_pixel(dice), dice.between(0.01, 0.2)));
        else
            out.push_back(round_polygon(dice, {dice.unit(), dice.unit()}, dice.between(0.02, 0.6),
                                        dice.between(0.02, 0.6), dice.number(3, 6)));
    }
}

constexpr Family kFamilies[] = {
    {"random", random},
    {"grid-of-eighths", grid_of_eighths},
    {"grid-of-quarters", grid_of_quarters},
    {"fan", fan},
    {"mesh-layers", mesh_layers},
    {"t-junctions-exact", t_junctions_exact},
    {"t-junctions-rounded", t_junctions_rounded},
    {"slivers", slivers},
    {"near-parallel", near_parallel},
    {"collinear-overlap", collinear_overlap},
    {"ulp-twins", ulp_twins},
    {"nested", nested},
    {"border-and-corners", border_and_corners},
    {"identical", identical},
    {"touching-from-inside", touching_from_inside},
    {"notches", notches},
    {"duplicates", duplicates},
    {"tiny-numbers", tiny_numbers},
    {"huge", huge},
    {"enormous", enormous},
    {"wires", wires},
    {"edge-on", edge_on},
    {"whole-pixels", whole_pixels},
    {"many-corners", many_corners},
    {"tiny-faces", tiny_faces},
    {"lattice", lattice},
    {"crowd", crowd},
};

/// Planes as seen from the pixel: w = a u + b v + c with u, v from its corner.
DepthPlane plane_seen_from(PixelIndex pixel, double a, double b, double c) {
    return {a, b, c - a * pixel.x - b * pixel.y};
}

std::vector<DepthPlane> random_planes(Dice& dice, PixelIndex pixel, std::size_t n) {
    std::vector<DepthPlane> planes;
    const int kind = dice.number(0, 6);
    const double scale = std::pow(10, dice.between(-6, 1));
    const DepthPlane base =
        plane_seen_from(pixel, scale * dice.between(-1, 1), scale * dice.between(-1, 1), dice.between(1, 2));
    const Point pivot{dice.unit(), dice.unit()};
    for (std::size_t i = 0; i < n; ++i) {
        const double a = scale * dice.between(-1, 1), b = scale * dice.between(-1, 1);
        DepthPlane plane;
        switch (kind) {
            case 0:
                plane = plane_seen_from(pixel, a, b, dice.between(1, 2));
                break;  // unrelated
            case 1:
                plane = {0, 0, double(dice.number(0, 3))};
                break;  // steps, with ties
            case 2:
                plane = plane_seen_from(pixel, a, b, -a * pivot.x - b * pivot.y);
                break;  // all through a point
            case 3:
                plane = {step_ulps(base.a, dice.number(-2, 2)), step_ulps(base.b, dice.number(-2, 2)),
                         step_ulps(base.c, dice.number(-1, 1))};
                break;  // nearly coplanar
            case 4:
                plane = base;
                break;  // coplanar
            case 5:
                plane = dice.one_in(2) ? base : plane_seen_from(pixel, a, b, dice.between(1, 2));
                break;
            default: {  // nearly through a point
                const double tilt = scale * std::pow(10, -dice.between(6, 15));
                plane = plane_seen_from(pixel, base.a + tilt * dice.between(-1, 1),
                                        base.b + tilt * dice.between(-1, 1), 1);
            }
        }
        planes.push_back(plane);
    }
    return planes;
}

}  // namespace

std::span<const Family> families() {
    return kFamilies;
}

PixelCase random_pixel(const Family& family, Dice& dice, bool with_depth) {
    PixelCase pixel_case;
    pixel_case.id = family.name;
    const PixelIndex places[] = {{0, 0}, {0, 0}, {4095, 2159}, {412, 233}, {-3, 7}};
    pixel_case.pixel = places[dice.number(0, 4)];
    family.faces(dice, pixel_case.polygons);
    if (family.name != "crowd" && pixel_case.polygons.size() > 8) pixel_case.polygons.resize(8);
    for (Ring& ring : pixel_case.polygons) {
        if (dice.one_in(2)) std::reverse(ring.begin(), ring.end());
        for (Point& p : ring) p = {p.x + pixel_case.pixel.x, p.y + pixel_case.pixel.y};
    }
    if (with_depth) pixel_case.depth = random_planes(dice, pixel_case.pixel, pixel_case.polygons.size());
    return pixel_case;
}

}  // namespace keikan::test
