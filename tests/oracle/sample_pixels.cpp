// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace keikan::oracle {
namespace {

using Random = std::mt19937_64;

constexpr std::array<std::string_view, 21> kFamilies = {
    "random",        "grid4",  "grid8",    "shared-vertex", "shared-edge",     "t-junction", "collinear",
    "ulp-twins",     "sliver", "nested",   "identical",     "cyclic",          "through",    "coplanar",
    "near-coplanar", "huge",   "denormal", "border-touch",  "repeated-points", "fan",        "rounded-quad"};

double unit(Random& random) {
    return std::uniform_real_distribution<double>(0, 1)(random);
}
double between(Random& random, double low, double high) {
    return low + (high - low) * unit(random);
}
int whole(Random& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}
Point anywhere(Random& random) {
    return {between(random, -0.3, 1.3), between(random, -0.3, 1.3)};
}

DepthPlane tilted_plane(Random& random) {
    return {between(random, -1, 1), between(random, -1, 1), between(random, 0, 2)};
}

/// Convex up to rounding: corners on an ellipse.
Ring ellipse_ring(Random& random, Point centre, double radius) {
    std::vector<double> angles(static_cast<std::size_t>(whole(random, 3, 6)));
    for (double& angle : angles) angle = between(random, 0, 2 * std::numbers::pi);
    std::ranges::sort(angles);
    const double flat = between(random, 0.2, 1);
    Ring ring;
    for (const double angle : angles)
        ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * flat * std::sin(angle)});
    return ring;
}

Ring triangle_on_grid(Random& random, int n) {
    Ring ring(3);
    for (Point& p : ring) p = {whole(random, 0, n) / double(n), whole(random, 0, n) / double(n)};
    return ring;
}

Point along(Point p, Point q, double t) {
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

Point nudged(Random& random, Point p) {
    const auto step = [&](double v) {
        const int ulps = whole(random, -1, 1);
        return ulps == 0 ? v : std::nextafter(v, ulps * std::numeric_limits<double>::infinity());
    };
    return {step(p.x), step(p.y)};
}

/// Two triangles on either side of p q, and others that use one of its ends.
void add_mesh_edge(Random& random, std::vector<Ring>& rings, Point p, Point q) {
    rings.push_back({p, q, anywhere(random)});
    rings.push_back({q, p, anywhere(random)});
}

Ring huge_ring(Random& random) {
    const double angle = between(random, 0, 2 * std::numbers::pi);
    const Point near = anywhere(random);
    const double reach = std::pow(10, between(random, 2, 6));
    const auto ray = [&](double turn, double length) {
        return Point{near.x + length * std::cos(angle + turn), near.y + length * std::sin(angle + turn)};
    };
    return {near, ray(0, reach), ray(between(random, 1e-6, 2), reach * unit(random))};
}

std::vector<Ring> rings_of(std::string_view family, Random& random) {
    std::vector<Ring> rings;
    const int count = whole(random, 4, 9);
    const Point hub = {unit(random), unit(random)};
    const Point other = {unit(random), unit(random)};
    const Ring base = {anywhere(random), anywhere(random), anywhere(random)};
    for (int i = 0; static_cast<int>(rings.size()) < count; ++i) {
        const double radius = between(random, 0.1, 0.8);
        if (family == "grid4") {
            rings.push_back(triangle_on_grid(random, 4));
        } else if (family == "grid8") {
            rings.push_back(triangle_on_grid(random, 8));
        } else if (family == "shared-vertex") {
            rings.push_back({hub, anywhere(random), anywhere(random)});
        } else if (family == "shared-edge") {
            add_mesh_edge(random, rings, hub, i % 2 == 0 ? other : anywhere(random));
        } else if (family == "t-junction") {
            const double grain = 1.0 / 16;
            const Point p = {grain * whole(random, 0, 16), grain * whole(random, 0, 16)};
            const Point q = {grain * whole(random, 0, 16), grain * whole(random, 0, 16)};
            rings.push_back({p, q, anywhere(random)});
            rings.push_back({along(p, q, 0.5), anywhere(random), anywhere(random)});
        } else if (family == "collinear") {
            const double from = whole(random, -1, 4) / 4.0, to = whole(random, 0, 5) / 4.0;
            rings.push_back({{from, from / 2 + 0.25}, {to, to / 2 + 0.25}, anywhere(random)});
        } else if (family == "ulp-twins") {
            rings.push_back({nudged(random, base[0]), nudged(random, base[1]), nudged(random, base[2])});
        } else if (family == "sliver") {
            const Point p = anywhere(random), q = anywhere(random);
            const double width = std::pow(10, between(random, -17, -2));
            rings.push_back({p, q, {q.x + width, q.y - width}, {p.x + width, p.y - width}});
        } else if (family == "nested") {
            rings.push_back(ellipse_ring(random, {0.5, 0.5}, 0.1 * (i + 1)));
        } else if (family == "identical") {
            rings.push_back(i % 3 == 0 ? Ring{anywhere(random), anywhere(random), anywhere(random)}
                                       : rings.back());
        } else if (family == "huge") {
            rings.push_back(huge_ring(random));
        } else if (family == "denormal") {
            const double tiny = std::ldexp(unit(random), -whole(random, 900, 1060));
            const double small = std::ldexp(unit(random), -whole(random, 30, 300));
            rings.push_back({{tiny, small}, {between(random, 0.1, 1), tiny}, {small, unit(random)}});
        } else if (family == "border-touch") {
            const std::array<double, 4> places = {-0.5, 0, 1, 0.5};
            Ring ring(3);
            for (Point& p : ring)
                p = {places[static_cast<std::size_t>(whole(random, 0, 3))],
                     places[static_cast<std::size_t>(whole(random, 0, 3))]};
            rings.push_back(ring);
        } else if (family == "repeated-points") {
            const Point p = anywhere(random), q = anywhere(random), r = anywhere(random);
            if (i % 2 == 0) rings.push_back({p, p, q, q, q, r, p});
            if (i % 2 == 1) rings.push_back({p, q, p, q});
        } else if (family == "fan") {
            const double step = 2 * std::numbers::pi / count;
            const auto rim = [&](int k) {
                return Point{hub.x + 0.6 * std::cos(step * (k % count)),
                             hub.y + 0.6 * std::sin(step * (k % count))};
            };
            rings.push_back({hub, rim(i), rim(i + 1)});
        } else if (family == "rounded-quad") {
            const Point p = anywhere(random), q = anywhere(random), r = anywhere(random);
            rings.push_back({p, along(p, q, unit(random)), q, along(q, r, unit(random)), r});
        } else {
            rings.push_back(ellipse_ring(random, anywhere(random), radius));
        }
        if (whole(random, 0, 1) == 1) std::ranges::reverse(rings.back());
    }
    return rings;
}

std::vector<DepthPlane> depth_of(std::string_view family, std::size_t count, Random& random) {
    std::vector<DepthPlane> planes(count);
    const DepthPlane base = tilted_plane(random);
    for (std::size_t i = 0; i < count; ++i) {
        planes[i] = tilted_plane(random);
        if (family == "cyclic") {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
            const double a = std::cos(angle), b = std::sin(angle);
            planes[i] = {a, b, 1 - 0.5 * (a + b)};
        } else if (family == "coplanar" || family == "identical") {
            planes[i] = base;
        } else if (family == "near-coplanar" || family == "ulp-twins") {
            const Point ab = nudged(random, {base.a, base.b});
            planes[i] = {ab.x, ab.y, nudged(random, {base.c, 0}).x};
        } else if (family == "denormal") {
            planes[i] = {std::ldexp(unit(random), -whole(random, 0, 1060)), unit(random),
                         1e-300 * unit(random)};
        } else if (family == "grid4" || family == "border-touch") {
            planes[i] = {double(whole(random, -1, 1)), double(whole(random, -1, 1)),
                         double(whole(random, -1, 1))};
        }
    }
    return planes;
}

void move_to_pixel(PixelCase& question) {
    for (Ring& ring : question.polygons)
        for (Point& p : ring) p = {p.x + question.pixel.x, p.y + question.pixel.y};
    if (!question.depth) return;
    for (DepthPlane& plane : *question.depth)
        plane.c -= plane.a * question.pixel.x + plane.b * question.pixel.y;
}

}  // namespace

std::span<const std::string_view> sample_families() {
    return kFamilies;
}

PixelCase sample_pixel(std::string_view family, std::mt19937_64& random) {
    if (std::ranges::find(kFamilies, family) == kFamilies.end())
        throw std::invalid_argument("unknown family");
    PixelCase question;
    question.id = family;
    const bool in_corner = family == "denormal" || whole(random, 0, 2) == 0;
    if (!in_corner) question.pixel = {whole(random, 0, 1) == 0 ? 4095 : 517, 2159};
    question.polygons = rings_of(family, random);
    const bool about_depth =
        family == "cyclic" || family == "through" || family == "coplanar" || family == "near-coplanar";
    if (about_depth || whole(random, 0, 1) == 1)
        question.depth = depth_of(family, question.polygons.size(), random);
    move_to_pixel(question);
    return question;
}

PixelCase terrain_pixel(std::mt19937_64& random) {
    PixelCase question;
    question.id = "terrain";
    question.pixel = {whole(random, 0, 999), whole(random, 0, 649)};
    question.depth.emplace();
    // Three faces of a mesh around a vertex in the pixel, then seven sheets of three behind it.
    for (int sheet = 0; sheet < 8; ++sheet) {
        const Point hub = {unit(random), unit(random)};
        const double turn = between(random, 0, 2 * std::numbers::pi), reach = between(random, 2, 20);
        const double near = 0.01 / (1 + sheet);
        for (int k = 0; k < 3 && question.polygons.size() < 23; ++k) {
            const auto rim = [&](int i) {
                const double angle = turn + (i % 3) * 2 * std::numbers::pi / 3;
                return Point{hub.x + reach * std::cos(angle), hub.y + reach * std::sin(angle)};
            };
            question.polygons.push_back({hub, rim(k), rim(k + 1)});
            const double a = near * between(random, -0.02, 0.02), b = near * between(random, -0.02, 0.02);
            question.depth->push_back({a, b, near - a * hub.x - b * hub.y});
        }
    }
    move_to_pixel(question);
    return question;
}

PixelCase crowded_pixel(int bars) {
    std::mt19937_64 random(1);
    PixelCase question;
    question.id = "crowd";
    question.pixel = {500, 300};
    question.depth.emplace();
    for (int i = 0; i < bars; ++i) {
        const Point middle = {unit(random), unit(random)};
        const double angle = between(random, 0, 2 * std::numbers::pi);
        const double thick = between(random, 0.005, 0.05), reach = between(random, 0.5, 5);
        const Point way = {reach * std::cos(angle), reach * std::sin(angle)};
        const Point side = {-thick * std::sin(angle), thick * std::cos(angle)};
        question.polygons.push_back({{middle.x - way.x, middle.y - way.y},
                                     {middle.x + way.x, middle.y + way.y},
                                     {middle.x + way.x + side.x, middle.y + way.y + side.y},
                                     {middle.x - way.x + side.x, middle.y - way.y + side.y}});
        question.depth->push_back(
            {between(random, -0.01, 0.01), between(random, -0.01, 0.01), between(random, 1, 1.05)});
    }
    move_to_pixel(question);
    return question;
}

}  // namespace keikan::oracle
