// SPDX-License-Identifier: Apache-2.0
//
// The paper's clipper takes shortcuts where they are certain. Each is compared with the long way here, and
// has a case that must not take it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <tuple>

#include "answers.hpp"
#include "area_of.hpp"
#include "grid_polygons.hpp"
#include "lattice_line.hpp"

using namespace keikan;
using namespace keikan::test;

namespace {

using Lattice = IntersectionClassifier::Lattice;
using Position = IntersectionClassifier::Position;

Ring repeated(const Ring& ring, std::size_t times) {
    Ring result;
    for (std::size_t k = 0; k < times; ++k) result.insert(result.end(), ring.begin(), ring.end());
    return result;
}

Ring scaled(Ring ring, double factor) {
    for (Point& p : ring) p = {p.x * factor, p.y * factor};
    return ring;
}

/// Convex polygons of the 3 x 3 grid, and a ring with a notch, one that touches and one that crosses itself.
std::vector<Ring> subjects() {
    std::vector<Ring> rings = grid_polygons(3, true);
    rings.push_back({{0, 0}, {2, 0}, {1, 1}, {0, 2}});
    rings.push_back({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}});
    rings.push_back({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    return rings;
}

auto named(const Contact& c) {
    return std::tuple(c.kind, c.turn, c.subject, c.clip);
}

}  // namespace

TEST_CASE("lattice_line: sides are those of orient2d, from on the line to a step of the grid beside it",
          "[clip][exact]") {
    Dice dice(3);
    constexpr double kStep = 0x1p-53;
    const auto any_point = [&] { return Point{dice.unit(), dice.unit()}; };
    long on = 0, wrong = 0, wrong_in_sets = 0, misjudged_in_double = 0;
    for (int i = 0; i < 20000; ++i) {
        Point a = any_point(), b = any_point();
        if (dice.one_in(4)) b.x = a.x;
        if (dice.one_in(4)) b.y = a.y;
        if (dice.one_in(4)) b = {a.x, a.y > 0.5 ? a.y - kStep : a.y + kStep};
        const double along = dice.one_in(8) ? 0 : dice.one_in(8) ? 1 : dice.unit();
        const Point near{a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)};
        Point points[64];
        for (Point& p : points) {
            const auto beside = [&](double v) {
                return std::clamp((v + 0.5) - 0.5 + dice.number(-1, 1) * kStep, 0.0, 1.0);
            };
            p = dice.one_in(8) ? any_point() : Point{beside(near.x), beside(near.y)};
        }
        const clip::LatticeLine line(a, b);
        const std::size_t n = static_cast<std::size_t>(dice.number(1, 64));
        const clip::SideSets sets = line.sides(points, n);
        for (std::size_t k = 0; k < n; ++k) {
            const Point p = points[k];
            const int truth = static_cast<int>(orient2d(a, b, p));
            const double rounded = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            on += truth == 0;
            misjudged_in_double += (rounded > 0) != (truth > 0) || (rounded < 0) != (truth < 0);
            wrong += line.side(p) != truth;
            const int in_sets = (sets.outside >> k & 1) != 0 ? -1 : (sets.on >> k & 1) != 0 ? 0 : 1;
            wrong_in_sets += in_sets != truth;
        }
        if (n < 64) wrong_in_sets += (sets.outside >> n) != 0 || (sets.on >> n) != 0;
    }
    CHECK(wrong == 0);
    CHECK(wrong_in_sets == 0);
    CHECK(on > 1000);
    CHECK(misjudged_in_double > 1000);  // so the exact way was needed, and taken
}

TEST_CASE("classify_intersections: on the pixel's grid classes and turns are the same", "[clip]") {
    IntersectionClassifier on_grid(Lattice::Pixel), anywhere(Lattice::Doubles);
    Dice dice(4);
    const auto moved = [&](const Ring& ring) {  // by a step of the grid, most of them
        Ring result = scaled(ring, 0.25);
        for (Point& p : result)
            p = {std::max(0.0, p.x + dice.number(-1, 1) * 0x1p-53),
                 std::max(0.0, p.y + dice.number(-1, 1) * 0x1p-53)};
        return result;
    };
    const std::vector<Ring> clippers = grid_polygons(3, true);
    long compared = 0;
    for (const Ring& a : subjects())
        for (const Ring& b : clippers)
            for (const bool move : {false, true}) {
                const Ring subject = move ? moved(a) : scaled(a, 0.25), clip = scaled(b, 0.25);
                const auto found = on_grid(subject, clip), expected = anywhere(subject, clip);
                REQUIRE(std::ranges::equal(found, expected, {}, named, named));
                REQUIRE(on_grid.winding_outside_first_edge() == anywhere.winding_outside_first_edge());
                compared += static_cast<long>(found.size());
            }
    CHECK(compared > 100000);
}

TEST_CASE("classify_intersections: a ring of more than 64 vertices is found as a short one is", "[clip]") {
    // A ring walked often enough is one of many vertices; its contacts are those of one walk, as often.
    IntersectionClassifier classify, classify_long;
    for (const Lattice lattice : {Lattice::Doubles, Lattice::Pixel}) {
        classify = IntersectionClassifier(lattice);
        classify_long = IntersectionClassifier(lattice);
        for (const Ring& a : subjects())
            for (const Ring& b : grid_polygons(3, true)) {
                const Ring subject = scaled(a, 0.5), clip = scaled(b, 0.5);
                const std::size_t n = subject.size(), times = 64 / n + 1;
                const auto once = classify(subject, clip);
                const Ring walked = repeated(subject, times);
                const auto often = classify_long(walked, clip);
                REQUIRE(often.size() == times * once.size());
                bool same = true;
                for (std::size_t i = 0; i < often.size(); ++i) {
                    Contact expected = once[i % once.size()];
                    expected.subject += static_cast<std::uint32_t>(i / once.size() * n);
                    same = same && often[i] == expected;
                }
                REQUIRE(same);
                REQUIRE(classify_long.winding_outside_first_edge() ==
                        static_cast<int>(times) * classify.winding_outside_first_edge());
            }
    }
}

TEST_CASE("ring_difference: a ring of more than 64 vertices leaves as much as its walks one by one",
          "[clip]") {
    RingDifference subtract(Lattice::Doubles);
    SignedRings rest;
    const auto area_left = [&](const Ring& subject, const Ring& clip) {
        rest.clear();
        subtract(subject, 1, clip, rest);
        return area_of(rest);
    };
    for (const Ring& a : subjects())
        for (const Ring& b : grid_polygons(3, true)) {
            const std::size_t times = 64 / a.size() + 1;
            const double one_by_one = static_cast<double>(times) * area_left(a, b);
            const double bound = static_cast<double>(times) * 20 * 3 * kCrossingError;
            REQUIRE(std::abs(area_left(repeated(a, times), b) - one_by_one) <= bound);
        }
}

TEST_CASE("classify_intersections: rings apart have nothing in common, those within leave nothing",
          "[clip]") {
    IntersectionClassifier classify, classify_all;
    long apart = 0, within = 0, open = 0, open_with_nothing_in_common = 0;
    for (const Ring& a : grid_polygons(3, true))
        for (const Ring& b : grid_polygons(3, true)) {
            const GridRational common = area(intersection(rational(a), rational(b)));
            switch (classify.position(a, b)) {
                case Position::Apart:
                    ++apart;
                    REQUIRE(common == GridRational(0));
                    break;
                case Position::Within:
                    ++within;
                    REQUIRE(common == area(rational(a)));
                    break;
                case Position::Open: {  // an edge of the subject alone may keep them apart: then it is Open
                    ++open;
                    open_with_nothing_in_common += common == GridRational(0);
                    REQUIRE(common != area(rational(a)));
                    const auto contacts = classify.contacts();
                    REQUIRE(std::ranges::equal(contacts, classify_all(a, b)));
                }
            }
        }
    CHECK(apart > 1000);
    CHECK(within > 500);
    CHECK(open > 10000);
    CHECK(open_with_nothing_in_common > 100);
}

TEST_CASE("classify_intersections: a ring without area on an edge of the clipper is within it, not apart",
          "[clip][degenerate]") {
    const Ring clip{{0, 0}, {2, 0}, {2, 2}};
    IntersectionClassifier classify;
    RingDifference subtract(Lattice::Doubles);
    SignedRings rest;
    for (const Ring& flat : {Ring{{0, 0}, {2, 0}, {1, 0}}, Ring{{0, 0}, {1, 1}, {2, 2}, {1, 1}}}) {
        CHECK(classify.position(flat, clip) == Position::Within);
        subtract(flat, 1, clip, rest);
        CHECK(rest.empty());
    }
    CHECK(classify.position(Ring{{-1, 0}, {2, 0}, {1, 0}}, clip) == Position::Open);
}

TEST_CASE("ring_difference: contacts are told where none was needed, too", "[clip]") {
    RingDifference subtract(Lattice::Doubles);
    IntersectionClassifier classify;
    SignedRings rest;
    long unneeded = 0;
    for (const Ring& a : grid_polygons(3, true))
        for (const Ring& b : grid_polygons(3, true)) {
            rest.clear();
            subtract(a, 1, b, rest);
            REQUIRE(std::ranges::equal(subtract.contacts(), classify(a, b)));
            if (classify.position(a, b) != Position::Apart) continue;
            unneeded += static_cast<long>(subtract.contacts().size());
            REQUIRE(rest.size() == 1);
            REQUIRE(std::ranges::equal(rest.ring(0), a));
        }
    CHECK(unneeded > 1000);
}

TEST_CASE("ring_difference: two turns are joined with regard to what winds around the clipper besides",
          "[clip]") {
    // Once around the clipper and once into it: two turns, and a whole copy of the clipper.
    const Ring clip{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
    Ring subject{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {-1, -1}, {5, -1}, {5, 2}, {2, 2}, {2, 5}, {-1, 5}};
    const double outside =
        16 + (36 - 9) - 4 - 3 + 0;  // inner square, outer one less its corner, less the clipper
    RingDifference subtract(Lattice::Doubles);
    for (std::size_t start = 0; start < subject.size(); ++start) {
        for (std::size_t edge = 0; edge < clip.size(); ++edge) {
            Ring turned = clip;
            std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(edge), turned.end());
            SignedRings rest;
            subtract(subject, 1, turned, rest);
            const auto turns = std::ranges::count_if(subtract.contacts(),
                                                     [](const Contact& c) { return c.turn != Turn::Touch; });
            CHECK(turns == 2);
            CHECK(area_of(rest) == outside + twice_signed_area(subject) / 2 - (16 + 36 - 9));
        }
        std::rotate(subject.begin(), subject.begin() + 1, subject.end());
    }
    CHECK(subtract.folds() == subject.size() * clip.size());  // told, since no face is ever such a ring
}

TEST_CASE("visible_areas: to watch the clip steps does not change a bit of areas and outlines",
          "[clip][property]") {
    VisibleAreas unwatched(Engine::Traversal), watched(Engine::Traversal);
    std::size_t steps = 0;
    watched.observe([&](const ClipStep&) { ++steps; });
    const auto kept = [](std::span<const VisibleOutline> outlines) {
        std::vector<std::tuple<std::uint32_t, int, Ring>> copy;
        for (const VisibleOutline& o : outlines)
            copy.push_back({o.face, o.sign, {o.ring.begin(), o.ring.end()}});
        return copy;
    };
    bool same = true;
    for_all_families(31, 30, [&](const PixelCase& pixel_case, Dice&, std::string_view) {
        const Answer seen = ask(unwatched, pixel_case), also_seen = ask(watched, pixel_case);
        same = same && same_bits(seen, also_seen, same_names(pixel_case.polygons.size()));
        same = same && kept(unwatched.outlines()) == kept(watched.outlines());
        same =
            same && kept(unwatched.outlines()) == kept(watched.outlines());  // to ask again changes nothing
    });
    CHECK(same);
    CHECK(steps > 10000);
}

TEST_CASE("visible_areas: the outlines of each face and of the background add up to its area", "[clip]") {
    // The background's area is what the faces leave of 1; its outline is found by clip steps of its own.
    VisibleAreas visible_areas(Engine::Traversal);
    double worst = 0;
    for_all_families(32, 60, [&](const PixelCase& pixel_case, Dice&, std::string_view family) {
        const Answer seen = ask(visible_areas, pixel_case);
        std::vector<double> sums(pixel_case.polygons.size() + 1, 0);
        for (const VisibleOutline& o : visible_areas.outlines())
            sums[std::min<std::size_t>(o.face, sums.size() - 1)] += o.sign * twice_signed_area(o.ring) / 2;
        const double bound = family == "crowd" ? kAreaSumError : kVisibleAreaError;
        for (std::uint32_t face = 0; face + 1 < sums.size(); ++face)
            worst = std::max(worst, std::abs(sums[face] - seen.area(face)) / bound);
        worst = std::max(worst, std::abs(sums.back() - seen.background) / bound);
    });
    CHECK(worst <= 1);
}
