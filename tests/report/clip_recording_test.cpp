// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/clip_recording.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "crosscheck/pixel_kinds.hpp"
#include "fuzz/degenerate_families.hpp"
#include "keikan/clip/ring_difference.hpp"

using namespace keikan;
using namespace keikan::report;
using crosscheck::bit_of;
using crosscheck::PixelKind;

namespace {

ClipRecording recorded_case(const PixelCase& asked, Engine engine = Engine::Traversal) {
    const std::vector<FaceView> faces = asked.faces();
    return recorded({asked.pixel, faces, asked.nearness()}, engine);
}

double area_of(const std::vector<SignedRing>& rings) {
    double area = 0;
    for (const SignedRing& r : rings) area += r.sign * twice_signed_area(r.ring) / 2;
    return area;
}

crosscheck::PixelKinds kinds_of(std::vector<Ring> polygons,
                                std::optional<std::vector<DepthPlane>> depth = {}) {
    PixelCase asked;
    asked.polygons = std::move(polygons);
    asked.depth = std::move(depth);
    return recorded_case(asked).kinds;
}

Ring box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

}  // namespace

TEST_CASE("recorded: the steps lead to the visible outlines, and the oracle agrees with every contact",
          "[report][property]") {
    std::size_t steps = 0;
    bool whole = true, agrees = true, shrinks = true;
    for (std::size_t f = 0; f < fuzz::kFamilyNames.size(); ++f)
        for (std::uint64_t i = 0; i < 12; ++i) {
            const auto family = static_cast<fuzz::Family>(f);
            const ClipRecording recording = recorded_case(fuzz::degenerate_case(family, 20261122, i));
            whole = whole && recording.whole;
            for (const RecordedStep& step : recording.steps) {
                const double before = step.subject.sign * twice_signed_area(step.subject.ring) / 2;
                shrinks = shrinks && std::abs(area_of(step.rest)) <= std::abs(before) + kVisibleAreaError;
                agrees =
                    agrees && step.exact &&
                    std::ranges::equal(step.contacts, *step.exact, [](const Contact& a, const Contact& b) {
                        return a.kind == b.kind && a.turn == b.turn && a.subject == b.subject &&
                               a.clip == b.clip;
                    });
                ++steps;
            }
        }
    CHECK(whole);
    CHECK(agrees);
    CHECK(shrinks);
    CHECK(steps > 1000);
}

TEST_CASE("recorded: two squares, step by step", "[report]") {
    PixelCase asked;
    asked.polygons = {box(0, 0, 0.5, 0.5), box(0.25, 0.25, 0.75, 0.75)};
    const ClipRecording recording = recorded_case(asked);
    REQUIRE(recording.steps.size() >= 2);  // the second square, then the background
    const RecordedStep& step = recording.steps[0];
    CHECK(step.subject.face == 1u);
    CHECK(step.clip_face == 0u);
    CHECK(step.contacts.size() == 2);
    CHECK(area_of(step.rest) == 0.25 - 0.0625);
    CHECK(recording.steps[1].subject.face == ClipStep::kBackground);
}

TEST_CASE("recorded: the published clipper's steps are its own", "[report]") {
    // Departure D2: a hole whose area Fig. 3 only remembers.
    PixelCase asked;
    asked.polygons = {box(0.25, 0.25, 0.625, 0.625), box(0.5, 0.5, 0.875, 0.875), box(0, 0, 1, 1)};
    const ClipRecording recording = recorded_case(asked, Engine::Published);
    REQUIRE_FALSE(recording.steps.empty());
    CHECK(
        std::ranges::any_of(recording.steps, [](const RecordedStep& s) { return s.remembered.has_value(); }));
    const auto first =
        std::ranges::find_if(recording.steps, [](const RecordedStep& s) { return s.contacts.size() == 2; });
    REQUIRE(first != recording.steps.end());
    CHECK(first->contacts[0].turn != first->contacts[1].turn);
}

TEST_CASE("KindsOfPixel: one pixel of each kind, and its likeness without it", "[report][crosscheck]") {
    const auto has = [](crosscheck::PixelKinds kinds, PixelKind kind) { return (kinds & bit_of(kind)) != 0; };
    using enum PixelKind;
    CHECK(has(kinds_of({box(0.25, 0, 0.5, 1), box(0, 0.25, 1, 0.5)}), EdgeEdge));
    const auto hole = kinds_of({box(0.25, 0.25, 0.5, 0.5), box(0, 0, 1, 1)});
    CHECK(has(hole, Hole));
    CHECK_FALSE(has(kinds_of({box(0, 0.25, 0.5, 0.5), box(0, 0, 1, 1)}), Hole));
    // A diamond's corner on the square's border, from inside; and from outside.
    const Ring within{{0.25, 0.5}, {0.5, 0.375}, {0.75, 0.5}, {0.5, 0.625}};
    CHECK(has(kinds_of({within, box(0.25, 0.125, 0.875, 0.875)}), TouchingInside));
    const Ring beside{{0.25, 0.5}, {0.125, 0.625}, {0.0625, 0.5}, {0.125, 0.375}};
    // (In front of a pixel that it does not reach the border of.)
    CHECK_FALSE(has(kinds_of({beside, box(0.25, 0.125, 0.875, 0.875)}), TouchingInside));

    const std::vector<DepthPlane> through{{1, 0, 0}, {-1, 0, 1}}, apart{{0, 0, 2}, {0, 0, 1}};
    CHECK(has(kinds_of({box(0, 0, 1, 1), box(0, 0, 1, 1)}, through), Interpenetration));
    CHECK_FALSE(has(kinds_of({box(0, 0, 1, 1), box(0, 0, 1, 1)}, apart), Interpenetration));
    // Three bars, each over the next (data/degenerate/cyclic).
    const std::vector<Ring> bars{{{0, 0}, {1, 0}, {1, 0.25}, {0, 0.25}},
                                 {{0, 0}, {0.25, 0}, {0.25, 1}, {0, 1}},
                                 {{0.75, 0}, {1, 0}, {1, 0.25}, {0.25, 1}, {0, 1}, {0, 0.75}}};
    const std::vector<DepthPlane> cycle{{-1, 0, 0.5}, {0, 1, -0.5}, {0.5, -0.5, 0}},
        stack{{0, 0, 3}, {0, 0, 2}, {0, 0, 1}};
    CHECK(has(kinds_of(bars, cycle), CyclicDepth));
    CHECK_FALSE(has(kinds_of(bars, stack), CyclicDepth));
}
