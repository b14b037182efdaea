// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small grids, exhaustively: both engines' areas and the class, turn and indices of every contact, by the
// exact oracle. tests/clip asks the same pairs for the area of RingDifference alone.
#include <catch2/catch.hpp>
#include <optional>

#include "crosscheck/check_cases.hpp"
#include "fuzz/grid_polygons.hpp"
#include "keikan/clip/orient2d.hpp"
#include "keikan/clip/ring_difference.hpp"

using namespace keikan;
using namespace keikan::crosscheck;
using fuzz::GridPolygon;

namespace {

Ring ring_of(const GridPolygon& polygon, double from, double step) {
    Ring ring;
    for (const fuzz::GridPlace at : polygon) ring.push_back({from + at.x * step, from + at.y * step});
    return ring;
}

std::vector<Ring> rings_of(const std::vector<GridPolygon>& polygons, double from, double step) {
    std::vector<Ring> rings;
    for (const GridPolygon& polygon : polygons) rings.push_back(ring_of(polygon, from, step));
    return rings;
}

/// Puts the cases that `next` gives to the oracle: all rungs for a few, the certified one for the others.
CheckSummary proven(const std::function<std::optional<PixelCase>()>& next) {
    CaseCheckOptions options;
    options.all_rungs_for_first = 16;
    options.rational_one_in = 1000;
    options.boolean_sets_one_in = 100'000;
    return check_cases(next, options);
}

CheckSummary proven_pairs(const std::vector<Ring>& rings) {
    std::size_t pair = 0;
    return proven([&]() -> std::optional<PixelCase> {
        if (pair == rings.size() * rings.size()) return std::nullopt;
        PixelCase question;
        question.polygons = {rings[pair % rings.size()], rings[pair / rings.size()]};
        ++pair;
        return question;
    });
}

/// Whether the part of `a` outside `b` is concave, touches itself or has a hole.
bool leaves_more_than_a_convex_piece(const Ring& a, const Ring& b) {
    static thread_local RingDifference subtract(IntersectionClassifier::Lattice::Pixel);
    SignedRings rest;
    subtract(a, 1, b, rest);
    if (rest.size() > 1) return true;
    if (rest.empty()) return false;
    const auto ring = rest.ring(0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (orient2d(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) == Sign::Negative)
            return true;
    return false;
}

/// A second clip of what is left of one polygon of the 3 x 3 grid outside another, where that is not convex:
/// by one in `one_in` polygons of the grid.
CheckSummary proven_second_clips(std::size_t one_in) {
    const std::vector<Ring> rings = rings_of(fuzz::polygons_of_3_x_3(), 0.25, 0.25);
    std::size_t pair = 0, second = rings.size();
    return proven([&]() -> std::optional<PixelCase> {
        while (second >= rings.size()) {
            if (pair == rings.size() * rings.size()) return std::nullopt;
            if (leaves_more_than_a_convex_piece(rings[pair / rings.size()], rings[pair % rings.size()]))
                second = pair % one_in;
            ++pair;
        }
        PixelCase question;
        question.polygons = {rings[(pair - 1) % rings.size()], rings[second],
                             rings[(pair - 1) / rings.size()]};
        second += one_in;
        return question;
    });
}

void check(const CheckSummary& found) {
    INFO(summary_json(found));
    CHECK(found.pass());
    CHECK(found.rungs.certified == found.pixels);
    CHECK(found.contacts.mismatches == 0);
    CHECK(found.contacts.folds == 0);
    CHECK(found.contacts.checked > found.pixels);
}

}  // namespace

TEST_CASE("proof: every ordered pair of triangles and convex quads on the 3 x 3 grid",
          "[proof][exhaustive]") {
    const CheckSummary found = proven_pairs(rings_of(fuzz::polygons_of_3_x_3(), 0, 0.5));
    CHECK(found.pixels == 21316);
    check(found);
}

TEST_CASE("proof: every ordered pair of triangles on the 4 x 4 grid", "[proof][exhaustive]") {
    const CheckSummary found = proven_pairs(rings_of(fuzz::triangles_of_4_x_4(), 0.125, 0.25));
    CHECK(found.pixels == 266256);
    check(found);
}

TEST_CASE("proof: second clips of results that are not convex, on the 3 x 3 grid", "[proof]") {
    const CheckSummary found = proven_second_clips(31);
    CHECK(found.pixels > 20'000);
    check(found);
}

TEST_CASE("proof: all second clips of results that are not convex, on the 3 x 3 grid",
          "[.][proof][exhaustive][long]") {
    const CheckSummary found = proven_second_clips(1);
    WARN(summary_json(found));
    check(found);
}
