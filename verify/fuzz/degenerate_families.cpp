// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/degenerate_families.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "fuzz/grid_polygons.hpp"
#include "fuzz/random_numbers.hpp"
#include "oracle/exact_hull.hpp"

namespace keikan::fuzz {

namespace {

using Rings = std::vector<Ring>;

/// What a generator means, whatever rounding made of its points.
Ring hull(const Ring& points) {
    return oracle::exact_hull(points);
}

double ulps(double value, int steps) {
    for (; steps > 0; --steps) value = std::nextafter(value, INFINITY);
    for (; steps < 0; ++steps) value = std::nextafter(value, -INFINITY);
    return value;
}

Point between(Point a, Point b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// Generators of one case. Each fills `rings`; those about nearness fill `planes` as well.
class Generator {
  public:
    Generator(RandomNumbers& random) : random_(random) {}

    Rings rings;
    std::vector<DepthPlane> planes;
    PixelIndex pixel;

    void make(Family family) {
        switch (family) {
            case Family::Random:
                return repeat(2, 7, [&] { return any_polygon(-0.4, 1.4); });
            case Family::Grid8:
                return repeat(2, 7, [&] { return grid_polygon(8); });
            case Family::Grid4:
                return repeat(2, 7, [&] { return grid_polygon(4); });
            case Family::Fan:
                return fan();
            case Family::MeshLayers:
                return mesh_layers();
            case Family::TJunction:
                return t_junctions(true);
            case Family::RoundedTJunction:
                return t_junctions(false);
            case Family::Sliver:
                return repeat(2, 6, [&] { return sliver(); });
            case Family::NearParallel:
                return near_parallel();
            case Family::Collinear:
                return collinear();
            case Family::UlpTwins:
                return ulp_twins();
            case Family::Nested:
                return nested();
            case Family::Border:
                return repeat(2, 7, [&] { return border_polygon(); });
            case Family::Identical:
                return identical();
            case Family::TouchingInside:
                return touching_inside();
            case Family::Notch:
                return notch();
            case Family::Duplicates:
                return duplicates();
            case Family::Denormal:
                return repeat(2, 5, [&] { return denormal_polygon(); });
            case Family::Huge:
                return huge();
            case Family::Cyclic:
                return cyclic();
            case Family::Interpenetrating:
                return interpenetrating();
            case Family::Coplanar:
                return coplanar();
            case Family::Mixed:
                return mixed();
            case Family::GridUlp:
                return grid_ulp();
            case Family::FarPowers:
                return far_powers();
        }
    }

    DepthPlane random_plane() {
        return {random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
    }

  private:
    template <typename Make>
    void repeat(int fewest, int most, Make make) {
        for (int n = random_.whole(fewest, most); n > 0; --n) rings.push_back(make());
    }

    Point any_point(double low, double high) {
        return {random_.between(low, high), random_.between(low, high)};
    }

    Ring any_polygon(double low, double high) {
        Ring points;
        for (int n = random_.whole(3, 6); n > 0; --n) points.push_back(any_point(low, high));
        return hull(points);
    }

    Point grid_point(int divisions) {
        const auto coordinate = [&] {
            return random_.whole(-1, divisions + 1) / static_cast<double>(divisions);
        };
        const double x = coordinate();
        return {x, coordinate()};
    }

    Ring grid_polygon(int divisions) {
        Ring points;
        for (int n = random_.whole(3, 6); n > 0; --n) points.push_back(grid_point(divisions));
        return hull(points);
    }

    void fan() {
        const Point centre = any_point(0.1, 0.9);
        const int n = random_.whole(3, 7);
        Ring rim;
        for (int i = 0; i < n; ++i) {
            const double angle = (i + random_.between(-0.2, 0.2)) * 6.283185307179586 / n;
            const double radius = random_.between(0.1, 0.9);
            rim.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
        }
        for (std::size_t i = 0; i < rim.size(); ++i) {
            rings.push_back({centre, rim[i], rim[(i + 1) % rim.size()]});
            if (random_.chance(0.3)) rings.push_back({rim[i], rim[(i + 2) % rim.size()], centre});
        }
    }

    void mesh_layers() {
        constexpr int kSide = 3;
        Ring vertices;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                vertices.push_back(
                    {0.5 * x + random_.between(-0.15, 0.15), 0.5 * y + random_.between(-0.15, 0.15)});
        const auto at = [&](int x, int y) { return vertices[static_cast<std::size_t>(y * kSide + x)]; };
        for (int layer = 0; layer < 2; ++layer)
            for (int cell = 0; cell < 4; ++cell) {
                const int x = cell % 2;
                const int y = cell / 2;
                if (random_.chance(0.3)) continue;
                const bool rising = random_.chance(0.5);
                const Point a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
                rings.push_back(rising ? Ring{a, b, c} : Ring{a, b, d});
                if (random_.chance(0.7)) rings.push_back(rising ? Ring{a, c, d} : Ring{b, c, d});
            }
        if (rings.empty()) rings.push_back({at(0, 0), at(1, 0), at(0, 1)});
        std::rotate(rings.begin(), rings.begin() + random_.whole(0, static_cast<int>(rings.size()) - 1),
                    rings.end());
    }

    /// A vertex of each further polygon lies on an edge of one before: exactly (halves of dyadic points), or
    /// wherever the rounded point of the edge falls.
    void t_junctions(bool exact) {
        rings.push_back(exact ? grid_polygon(8) : any_polygon(0, 1));
        for (int n = random_.whole(1, 5); n > 0; --n) {
            const Ring& base =
                rings[static_cast<std::size_t>(random_.whole(0, static_cast<int>(rings.size()) - 1))];
            if (base.size() < 2) continue;
            const auto edge = static_cast<std::size_t>(random_.whole(0, static_cast<int>(base.size()) - 1));
            const Point a = base[edge];
            const Point b = base[(edge + 1) % base.size()];
            const double t = exact ? random_.whole(0, 4) / 4.0 : random_.unit();
            const double s = exact ? random_.whole(0, 4) / 4.0 : random_.unit();
            Ring points{between(a, b, t), exact ? grid_point(8) : any_point(-0.2, 1.2)};
            points.push_back(random_.chance(0.5) ? between(a, b, s)
                             : exact             ? grid_point(8)
                                                 : any_point(-0.2, 1.2));
            rings.push_back(hull(points));
        }
    }

    Ring sliver() {
        const Point a = any_point(-0.3, 1.3);
        const Point b =
            random_.chance(0.3) && !rings.empty() && !rings[0].empty() ? rings[0][0] : any_point(-0.3, 1.3);
        const double thickness = std::pow(10.0, random_.between(-9, -3));
        const Point across{-(b.y - a.y) * thickness, (b.x - a.x) * thickness};
        Ring points{a, b, {b.x + across.x, b.y + across.y}};
        if (random_.chance(0.5)) points.push_back({a.x + across.x, a.y + across.y});
        return hull(points);
    }

    void near_parallel() {
        const Point a = any_point(-0.2, 0.3);
        const Point b = any_point(0.7, 1.2);
        repeat(2, 6, [&] {
            const double angle = std::pow(10.0, random_.between(-15, -4));
            const auto off = [&] { return (random_.unit() - 0.5) * angle; };
            Ring points{{a.x + off(), a.y + off()}, {b.x + off(), b.y + off()}, any_point(-0.2, 1.2)};
            if (random_.chance(0.4)) points.push_back(between(points[0], points[1], random_.unit()));
            return hull(points);
        });
    }

    void collinear() {
        const bool level = random_.chance(0.4);
        const Point a = level ? Point{-0.25, 0.5} : grid_point(8);
        const Point b = level ? Point{1.25, 0.5} : grid_point(8);
        repeat(2, 7, [&] {
            const double t = random_.whole(0, 8) / 8.0;
            const double s = random_.whole(0, 8) / 8.0;
            Ring points{between(a, b, t), between(a, b, s), grid_point(8)};
            if (random_.chance(0.3)) points.push_back(grid_point(8));
            return hull(points);
        });
    }

    void ulp_twins() {
        const Ring original = any_polygon(-0.1, 1.1);
        repeat(2, 7, [&] {
            Ring twin = original;
            for (Point& p : twin) p = {ulps(p.x, random_.whole(-1, 1)), ulps(p.y, random_.whole(-1, 1))};
            return hull(twin);
        });
    }

    void nested() {
        Ring ring = any_polygon(-0.2, 1.2);
        for (int n = random_.whole(2, 6); n > 0 && ring.size() >= 3; --n) {
            rings.push_back(ring);
            const Point centre = between(between(ring[0], ring[1], 0.5), ring[2], 1.0 / 3);
            const double shrink = random_.chance(0.2) ? 1 : random_.between(0.3, 0.99);
            for (Point& p : ring) p = between(centre, p, shrink);
            ring = hull(ring);
        }
        if (random_.chance(0.8)) std::reverse(rings.begin(), rings.end());
    }

    Ring border_polygon() {
        const auto coordinate = [&](bool on_border) {
            if (on_border) return static_cast<double>(random_.whole(0, 1));
            return random_.chance(0.2) ? ulps(random_.whole(0, 1), random_.whole(-1, 1))
                                       : random_.between(-0.5, 1.5);
        };
        Ring points;
        for (int n = random_.whole(3, 5); n > 0; --n) {
            const double x = coordinate(random_.chance(0.5));
            points.push_back({x, coordinate(random_.chance(0.5))});
        }
        return hull(points);
    }

    void identical() {
        const Ring original = random_.chance(0.5) ? any_polygon(-0.2, 1.2) : grid_polygon(4);
        repeat(2, 6, [&] {
            Ring again = original;
            if (!again.empty())
                std::rotate(again.begin(),
                            again.begin() + random_.whole(0, static_cast<int>(again.size()) - 1),
                            again.end());
            if (random_.chance(0.5)) std::reverse(again.begin(), again.end());
            return random_.chance(0.2) ? any_polygon(-0.2, 1.2) : again;
        });
    }

    void touching_inside() {
        const Ring outer = random_.chance(0.5) ? grid_polygon(8) : any_polygon(0, 1);
        if (outer.size() < 3) return rings.push_back(outer);
        for (int n = random_.whole(1, 5); n > 0; --n) {
            const auto i = static_cast<std::size_t>(random_.whole(0, static_cast<int>(outer.size()) - 1));
            const Point a = outer[i], b = outer[(i + 1) % outer.size()], c = outer[(i + 2) % outer.size()];
            const Point inside = between(between(a, c, 0.5), b, 0.25);
            Ring points{random_.chance(0.5) ? between(a, b, 0.5) : b, inside};
            points.push_back(random_.chance(0.5) ? between(b, c, 0.5) : between(a, c, 0.25));
            rings.push_back(hull(points));
        }
        rings.push_back(outer);
    }

    /// Two polygons leave a notch in a third; a fourth fills it, wholly or with a vertex on its tip.
    void notch() {
        const bool exact = random_.chance(0.6);
        const auto point = [&] { return exact ? grid_point(8) : any_point(0, 1); };
        const Point a = point(), b = point(), tip = point();
        rings.push_back(hull({a, b, tip}));
        rings.push_back(hull({tip, between(a, tip, 0.5), point()}));
        rings.push_back(hull({tip, b, point()}));
        if (random_.chance(0.5)) rings.push_back(hull({tip, between(b, tip, 0.5), between(a, tip, 0.5)}));
        rings.push_back(hull({point(), point(), point(), point()}));
        rings.push_back({{-0.25, -0.25}, {1.25, -0.25}, {1.25, 1.25}, {-0.25, 1.25}});
    }

    void duplicates() {
        repeat(2, 6, [&] {
            Ring ring = random_.chance(0.3) ? Ring{grid_point(4), grid_point(4)} : grid_polygon(4);
            Ring doubled;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                for (int n = random_.whole(1, 3); n > 0; --n) doubled.push_back(ring[i]);
                if (random_.chance(0.4))
                    doubled.push_back(between(ring[i], ring[(i + 1) % ring.size()], 0.5));
            }
            if (ring.size() < 3) doubled = ring;
            return doubled;
        });
    }

    Ring denormal_polygon() {
        const auto coordinate = [&]() -> double {
            switch (random_.whole(0, 5)) {
                case 0:
                    return random_.chance(0.5) ? 0.0 : -0.0;
                case 1:
                    return random_.between(-1, 1) * 1e-300;
                case 2:
                    return random_.whole(-3, 3) * 4.9406564584124654e-324;
                case 3:
                    return random_.between(-1, 1) * 0x1p-53;
                case 4:
                    return random_.whole(0, 1);
                default:
                    return random_.unit();
            }
        };
        Ring points;
        for (int n = random_.whole(3, 5); n > 0; --n) {
            const double x = coordinate();
            points.push_back({x, coordinate()});
        }
        return hull(points);
    }

    void huge() {
        pixel = {4095, 2159};
        const auto near = [&] {
            return Point{4095 + random_.between(-0.5, 1.5), 2159 + random_.between(-0.5, 1.5)};
        };
        repeat(2, 6, [&] {
            Ring points;
            for (int n = random_.whole(3, 4); n > 0; --n) {
                const double angle = random_.between(0, 6.283185307179586);
                const double reach = std::pow(10.0, random_.between(0, 6));
                const Point from = near();
                points.push_back(random_.chance(0.25) ? from
                                                      : Point{from.x + reach * std::cos(angle),
                                                              from.y + reach * std::sin(angle)});
            }
            return hull(points);
        });
        if (random_.chance(0.3)) rings.push_back(rings[0]);
    }

    void cyclic() {
        const int bars = random_.whole(3, 5);
        for (int i = 0; i < bars; ++i) {
            const double angle = i * 6.283185307179586 / bars + random_.between(-0.1, 0.1);
            const Point along{std::cos(angle), std::sin(angle)};
            const Point across{-along.y, along.x};
            const double side = random_.between(0.1, 0.25);
            const double width = random_.between(0.05, 0.2);
            const auto corner = [&](double s, double t) {
                return Point{0.5 + s * along.x + t * across.x, 0.5 + s * along.y + t * across.y};
            };
            rings.push_back(hull({corner(-0.6, side), corner(0.6, side), corner(0.6, side + width),
                                  corner(-0.6, side + width)}));
            // Nearer towards its own end: each bar passes over the next and under the one before.
            planes.push_back({along.x, along.y, -0.5 * (along.x + along.y) + random_.between(-0.01, 0.01)});
        }
    }

    void interpenetrating() {
        repeat(2, 6, [&] { return random_.chance(0.3) ? grid_polygon(8) : any_polygon(-0.3, 1.3); });
        const Point common = any_point(0.2, 0.8);
        for (std::size_t i = 0; i < rings.size(); ++i) {
            DepthPlane plane = random_plane();
            if (random_.chance(0.5))
                plane.c = -(plane.a * common.x + plane.b * common.y);  // through one point, nearly
            planes.push_back(plane);
        }
    }

    void coplanar() {
        repeat(2, 6, [&] { return random_.chance(0.5) ? grid_polygon(8) : any_polygon(-0.3, 1.3); });
        const DepthPlane common = random_plane();
        for (std::size_t i = 0; i < rings.size(); ++i) {
            DepthPlane plane = common;
            if (random_.chance(0.7))
                plane = {ulps(plane.a, random_.whole(-1, 1)), ulps(plane.b, random_.whole(-1, 1)),
                         ulps(plane.c, random_.whole(-1, 1))};
            planes.push_back(plane);
        }
    }

    void mixed() {
        Rings all;
        for (int n = random_.whole(2, 3); n > 0; --n) {
            rings.clear();
            make(static_cast<Family>(random_.whole(0, static_cast<int>(Family::Denormal))));
            for (const Ring& ring : rings)
                if (random_.chance(0.6)) all.push_back(ring);
        }
        if (all.empty()) all.push_back(any_polygon(0, 1));
        for (std::size_t i = all.size() - 1; i > 0; --i)
            std::swap(all[i], all[static_cast<std::size_t>(random_.whole(0, static_cast<int>(i)))]);
        rings = std::move(all);
    }

    /// Pairs that the exhaustive tests hold, and a second clipper for what the first leaves: each vertex
    /// beside its place of the grid by at most an ulp.
    void grid_ulp() {
        const bool triangles = random_.chance(1.0 / 3);
        const std::vector<GridPolygon>& polygons = triangles ? triangles_of_4_x_4() : polygons_of_3_x_3();
        // The multiples of an ulp of the first two places are those that the product rounds to, so that it
        // sees the very doubles; the third has vertices on the pixel's border, the last is far from the
        // origin.
        struct Place {
            double from, step;
            PixelIndex pixel;
        };
        const double step = triangles ? 0.125 : 0.1875;
        const Place places[] = {{0.5625, step, {}},
                                {0.53125, step, {}},
                                {0, triangles ? 1.0 / 3 : 0.5, {}},
                                {0.25, step, {}},
                                {4095.25, step, {4095, 2159}}};
        const Place& place = places[random_.whole(0, 4)];
        pixel = place.pixel;
        const double from_y = place.from - pixel.x + pixel.y;
        repeat(2, triangles ? 2 : 3, [&] {
            const GridPolygon& polygon =
                polygons[static_cast<std::size_t>(random_.whole(0, static_cast<int>(polygons.size()) - 1))];
            Ring ring;
            for (const GridPlace at : polygon) {
                const double x = ulps(place.from + at.x * place.step, random_.whole(-1, 1));
                ring.push_back({x, ulps(from_y + at.y * place.step, random_.whole(-1, 1))});
            }
            std::rotate(ring.begin(), ring.begin() + random_.whole(0, static_cast<int>(ring.size()) - 1),
                        ring.end());
            return ring;
        });
    }

    /// Needles and giants: the product of two coordinates is no double any more.
    void far_powers() {
        const auto coordinate = [&] {
            if (random_.chance(0.5)) return random_.whole(-2, 10) / 8.0;
            const double sign = random_.chance(0.5) ? -1 : 1;
            return sign * std::ldexp(random_.between(1, 2), random_.whole(-1074, 1022));
        };
        repeat(2, 4, [&] {
            Ring points;
            for (int n = random_.whole(3, 4); n > 0; --n) {
                const double x = coordinate();
                points.push_back({x, coordinate()});
            }
            return hull(points);
        });
    }

    RandomNumbers& random_;
};

}  // namespace

std::optional<Family> family_of(std::string_view name) {
    for (std::size_t f = 0; f < kFamilyNames.size(); ++f)
        if (kFamilyNames[f] == name) return static_cast<Family>(f);
    return std::nullopt;
}

PixelCase degenerate_case(Family family, std::uint64_t seed, std::uint64_t index) {
    RandomNumbers random(seed, static_cast<std::uint64_t>(family), index);
    Generator generator(random);
    generator.make(family);
    PixelCase result;
    result.id = std::string(name_of(family)) + "/" + std::to_string(seed) + "/" + std::to_string(index);
    result.pixel = generator.pixel;
    result.polygons = std::move(generator.rings);
    if (!generator.planes.empty()) {
        result.depth = std::move(generator.planes);
    } else if (family != Family::GridUlp && random.chance(0.25)) {
        result.depth.emplace();
        for (std::size_t i = 0; i < result.polygons.size(); ++i)
            result.depth->push_back(generator.random_plane());
    }
    return result;
}

}  // namespace keikan::fuzz
