// SPDX-License-Identifier: GPL-3.0-or-later
// Answers that can be worked out by hand.
#include <catch2/catch.hpp>

#include <limits>

#include "keikan/model/pixel_case.hpp"
#include "oracle/exact_areas.hpp"

using namespace keikan;
using namespace keikan::oracle;

namespace {

using Answer = std::vector<mpq_class>;  // the areas, then the background

Answer as_answer(const ExactAreas& exact) {
    Answer answer = exact.areas;
    answer.push_back(exact.background);
    return answer;
}

/// All rungs give `expected`.
void check(const PixelCase& question, const Answer& expected) {
    const auto faces = question.faces();
    CHECK(as_answer(areas_by_boolean_sets(question.pixel, faces, question.nearness())) == expected);
    CHECK(as_answer(areas_by_rational_splitting(question.pixel, faces, question.nearness())) == expected);

    CertifiedSplitting certified_areas;
    const auto certified = certified_areas(question.pixel, faces, question.nearness());
    REQUIRE(certified.certified);
    std::vector<CertifiedArea> areas = certified.areas;
    areas.push_back(certified.background);
    REQUIRE(areas.size() == expected.size());
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const mpq_class difference = expected[i] - mpq_class(areas[i].value);
        CHECK(difference <= mpq_class(areas[i].error));
        CHECK(-difference <= mpq_class(areas[i].error));
    }
}

mpq_class q(int over, int under) {
    mpq_class number(over, under);
    number.canonicalize();
    return number;
}

Ring square(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

PixelCase asked(std::vector<Ring> polygons, std::optional<std::vector<DepthPlane>> depth = {},
                PixelIndex pixel = {}) {
    PixelCase question;
    question.pixel = pixel;
    question.polygons = std::move(polygons);
    question.depth = std::move(depth);
    return question;
}

}  // namespace

TEST_CASE("oracle: an empty pixel is background", "[oracle]") {
    check(asked({}), {1});
}

TEST_CASE("oracle: a face larger than the pixel fills it", "[oracle]") {
    check(asked({square(-1e6, -1e6, 1e6, 1e6)}), {1, 0});
    check(asked({square(-1e6, -1e6, 1e6, 1e6)}, {}, {4095, 2159}), {1, 0});
}

TEST_CASE("oracle: the first of the list hides the others", "[oracle]") {
    check(asked({square(0, 0, 0.5, 1), square(0.25, 0, 1, 0.5)}), {q(1, 2), q(1, 4), q(1, 4)});
}

TEST_CASE("oracle: a hole is what the nearer face leaves", "[oracle]") {
    check(asked({square(0.25, 0.25, 0.625, 0.625), square(0.5, 0.5, 0.875, 0.875), square(0, 0, 1, 1)}),
          {q(9, 64), q(1, 8), q(47, 64), 0});
}

TEST_CASE("oracle: faces without area, or outside, show nothing", "[oracle]") {
    const Ring segment = {{0, 0}, {1, 1}}, point = {{0.5, 0.5}}, flat = {{0, 0}, {0.5, 0.5}, {1, 1}};
    check(asked({segment, point, {}, flat, square(1, 0, 2, 1), square(5, 5, 6, 6)}), {0, 0, 0, 0, 0, 0, 1});
}

TEST_CASE("oracle: a point may be repeated, and either orientation is the same face", "[oracle]") {
    const Ring there = {{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}};
    check(asked({there}), {q(1, 2), q(1, 2)});
    check(asked({Ring(there.rbegin(), there.rend())}), {q(1, 2), q(1, 2)});
}

TEST_CASE("oracle: an outline that is not convex is taken as its hull", "[oracle]") {
    check(asked({{{0, 0}, {0.5, 0.25}, {1, 0}, {1, 1}, {0, 1}}}), {1, 0});
}

TEST_CASE("oracle: two faces through each other meet where they are equally near", "[oracle]") {
    check(asked({square(0, 0, 1, 1), square(0, 0, 1, 1)}, std::vector<DepthPlane>{{1, 0, 0}, {0, 1, 0}}),
          {q(1, 2), q(1, 2), 0});
    check(asked({square(0, 0, 1, 1), square(0, 0, 1, 1)}, std::vector<DepthPlane>{{1, 0, 0}, {0, 0, 0.25}}),
          {q(3, 4), q(1, 4), 0});
}

TEST_CASE("oracle: where two faces coincide in depth the smaller id is seen", "[oracle]") {
    PixelCase question = asked({square(0, 0, 1, 1), square(0, 0, 0.5, 1)}, std::vector<DepthPlane>(2));
    check(question, {1, 0, 0});
    auto faces = question.faces();
    std::swap(faces[0].id, faces[1].id);
    CHECK(areas_by_boolean_sets({}, faces, Nearness::ByDepth).areas[1] == q(1, 2));
    CHECK(areas_by_rational_splitting({}, faces, Nearness::ByDepth).areas[1] == q(1, 2));
    CertifiedSplitting certified_areas;
    CHECK(certified_areas({}, faces, Nearness::ByDepth).areas[1].value == 0.5);
}

TEST_CASE("oracle: three bars of which each hides the next have no order, and an answer", "[oracle]") {
    // Each pair overlaps in a sixteenth of the pixel, and each bar loses one such part.
    const Ring upright = square(0, 0, 0.25, 1), flat = square(0, 0, 1, 0.25);
    const Ring slope = {{0, 1}, {0, 0.75}, {0.75, 0}, {1, 0}};  // 7/32
    check(asked({upright, flat, slope}, std::vector<DepthPlane>{{0, -3, 1}, {0, 0, 0}, {0, 0, -0.25}}),
          {q(3, 16), q(3, 16), q(5, 32), q(15, 32)});
}

TEST_CASE("oracle: planes that cross hide by halves", "[oracle]") {
    const Ring all = square(0, 0, 1, 1);
    check(asked({all, all, all}, std::vector<DepthPlane>{{1, 0, 0}, {-1, 0, 1}, {0, 0, 0.5}}),
          {q(1, 2), q(1, 2), 0, 0});
}

TEST_CASE("oracle: the smallest double still counts", "[oracle]") {
    const double least = std::numeric_limits<double>::denorm_min();
    const auto exact =
        areas_by_rational_splitting({}, asked({square(0, 0, least, 1)}).faces(), Nearness::InOrder);
    CHECK(exact.areas[0] > 0);
    CHECK(exact.areas[0] == mpq_class(least));
    check(asked({square(0, 0, least, 1), square(0, 0, 0.5, 1)}),
          {mpq_class(least), q(1, 2) - mpq_class(least), q(1, 2)});
}

TEST_CASE("oracle: corners may lie as far away as doubles reach", "[oracle]") {
    check(asked({{{-1e300, 0.5}, {1e300, 0.5}, {1e300, 1e300}, {-1e300, 1e300}}}), {q(1, 2), q(1, 2)});
    check(asked({square(-1e18, 0, 0.25, 1e18)}), {q(1, 4), q(3, 4)});
}

TEST_CASE("oracle: a needle 2^-758 wide and 2^549 high, where CGAL's intervals overflow, is decided",
          "[oracle]") {
    check(asked({{{0, 0.5}, {1, -0.125}, {-0x1.05p-758, -0x1.fep+548}}}), {q(1, 5), q(4, 5)});
    // As high, and right of the pixel's border by the least that doubles have.
    check(asked({{{-0x1p1022, 0.5}, {0x1p1022, 0.5}, {0x1p-1074, -0x1p1022}}}), {q(1, 2), q(1, 2)});
}

TEST_CASE("oracle: parts that touch at a point, where CGAL's differences give up, are answered", "[oracle]") {
    const auto quarters = [](Ring ring) {
        for (Point& p : ring) p = {p.x / 4, p.y / 4};
        return ring;
    };
    const PixelCase question =
        asked({quarters({{2, 3}, {4, 0}, {3, 4}}), quarters({{1, 0}, {0, 2}, {4, 1}}),
               quarters({{3, 3}, {0, 1}, {3, 0}}), quarters({{0, 1}, {1, 1}, {3, 4}})});
    const auto faces = question.faces();
    const auto exact = areas_by_boolean_sets({}, faces, Nearness::InOrder);
    CHECK(exact.background == q(6817, 13728));
    CHECK(exact.areas[3] == q(499, 14080));
    CHECK(exact == areas_by_rational_splitting({}, faces, Nearness::InOrder));
}
