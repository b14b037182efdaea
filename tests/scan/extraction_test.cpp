// SPDX-License-Identifier: Apache-2.0
//
// Extraction::Paper (2.1) against what it says, worked out slowly.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "../../src/scan/scanline_lengths.hpp"
#include "small_scenes.hpp"

using namespace keikan;
using namespace keikan::small_scenes;

namespace {

/// A crossing of the scanline rounds like a quotient of numbers up to 64 pixels.
constexpr double kLengthRounding = 64 * 8 * 0x1p-52;

/// Lengths along the scanline by brute force: all points where anything can change, and the nearest face at
/// the middle between each two of them. By id; the background's under kNobody.
constexpr FaceId kNobody = 0xFFFFFFFFu;

std::map<FaceId, double> slow_lengths(PixelIndex pixel, const ProjectedFaces& faces) {
    struct Piece {
        double begin, end;
        DepthPlane plane;
        FaceId id;
    };
    std::vector<Piece> pieces;
    const double row = pixel.y + 0.5;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Piece piece{1e9, -1e9, faces.plane[f], faces.id[f]};
        const auto outline = faces[f].outline;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Point p = outline[k], q = outline[(k + 1) % outline.size()];
            if ((p.y < row) == (q.y < row)) continue;
            const double x = p.x + (row - p.y) / (q.y - p.y) * (q.x - p.x);
            piece.begin = std::min(piece.begin, x);
            piece.end = std::max(piece.end, x);
        }
        if (piece.begin < piece.end) pieces.push_back(piece);
    }
    std::vector<double> stops{double(pixel.x), pixel.x + 1.0};
    const auto stop = [&](double x) {
        if (x > pixel.x && x < pixel.x + 1) stops.push_back(x);
    };
    for (const Piece& p : pieces) {
        stop(p.begin);
        stop(p.end);
        for (const Piece& q : pieces)
            stop(-((p.plane.b - q.plane.b) * row + (p.plane.c - q.plane.c)) / (p.plane.a - q.plane.a));
    }
    std::sort(stops.begin(), stops.end());
    std::map<FaceId, double> lengths;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const double x = (stops[i] + stops[i + 1]) / 2;
        FaceId nearest = kNobody;
        double best = -1e300;
        for (const Piece& p : pieces) {
            const double w = p.plane.a * x + p.plane.b * row + p.plane.c;
            if (p.begin < x && x < p.end && w > best) best = w, nearest = p.id;
        }
        lengths[nearest] += stops[i + 1] - stops[i];
    }
    return lengths;
}

ScanOptions paper_rule(double slope = 0.25) {
    ScanOptions options;
    options.extraction = Extraction::Paper;
    options.near_horizontal_slope = slope;
    return options;
}

}  // namespace

TEST_CASE("paper extraction: lengths along the scanline are those of a slow reference", "[scan][paper]") {
    const Camera view = camera({24, 16});
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
        const Geometry scene = geometry(soup(view, 40, seed));
        const ProjectedFaces faces = project_faces(scene, view);
        // Slope 0: no edge is near-horizontal, so no pixel is flagged.
        const auto all = shown(scanned(scene, view, paper_rule(0)), view.size);
        double worst = 0;
        for (int y = 0; y < view.size.height; ++y)
            for (int x = 0; x < view.size.width; ++x) {
                const Shown& pixel = all[at_pixel(view, x, y)];
                CHECK((!pixel.divided || pixel.division == Division::Scanline));
                auto difference = slow_lengths({x, y}, faces);
                difference[kNobody] -= pixel.background;
                for (const auto& [id, weight] : pixel.weights) difference[id] -= weight;
                for (const auto& [id, d] : difference) worst = std::max(worst, std::abs(d));
            }
        CHECK(worst <= 100 * kLengthRounding);  // where planes meet at a flat angle the point is less sharp
    }
}

TEST_CASE("paper extraction: pixels on a near-horizontal edge get exact areas, others lengths",
          "[scan][paper]") {
    const Camera view = camera({20, 20});
    Mesh mesh;
    add_rectangle(mesh, view, 3.3, 3.3, 15.6, 9.7, 10);
    const Geometry scene = geometry(mesh);
    const auto all = shown(scanned(scene, view, paper_rule()), view.size);
    for (int x = 3; x <= 15; ++x) {
        CHECK(all[at_pixel(view, x, 3)].division == Division::ExactAreas);
        CHECK(all[at_pixel(view, x, 3)].divided);
        CHECK(all[at_pixel(view, x, 9)].divided);
    }
    for (int y = 4; y <= 8; ++y) {  // the upright sides
        const Shown& left = all[at_pixel(view, 3, y)];
        REQUIRE(left.divided);
        CHECK(left.division == Division::Scanline);
        REQUIRE(left.weights.size() == 1);
        CHECK(std::abs(left.weights[0].second - 0.7) <= kLengthRounding);
        CHECK(std::abs(left.background - 0.3) <= kLengthRounding);
        CHECK_FALSE(all[at_pixel(view, 8, y)].divided);
    }
}

TEST_CASE("paper extraction: every outline of a conductor is flagged, however steep", "[scan][paper]") {
    const Camera view = camera({20, 20});
    Mesh mesh;
    add_face(mesh, view, {{5.25, 1, 10}, {5.75, 1, 10}, {5.75, 19, 10}, {5.25, 19, 10}});
    const auto as = [&](ObjectKind kind) {
        return shown(scanned(geometry(mesh, kind), view, paper_rule()), view.size)[at_pixel(view, 5, 8)];
    };
    CHECK(as(ObjectKind::Conductor).division == Division::ExactAreas);
    CHECK(as(ObjectKind::Tower).division == Division::Scanline);
}

TEST_CASE("paper extraction: a thin wire between two scanlines is seen only where it is flagged",
          "[scan][paper]") {
    const Camera view = camera({20, 4});
    Mesh mesh;
    add_rectangle(mesh, view, -1, 1.1, 21, 1.2, 10);
    const Geometry wire = geometry(mesh, ObjectKind::Conductor);
    CHECK(shown(scanned(wire, view, paper_rule()), view.size)[at_pixel(view, 7, 1)].weights.size() == 1);
    const Geometry rail = geometry(mesh, ObjectKind::Tower);
    CHECK(shown(scanned(rail, view, paper_rule(0)), view.size)[at_pixel(view, 7, 1)].weights.empty());
}

TEST_CASE("scanline_lengths: equal nearness shows the smaller id", "[scan][paper]") {
    const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<FaceView> faces{{3, square, {0, 0, 1}}, {7, square, {0, 0, 1}}};
    ScanlineLengths lengths;
    const auto parts = lengths({0, 0}, faces);
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].face == 0);
    CHECK(parts[0].weight == 1);
    CHECK(parts[0].x == 0.5f);
    CHECK(lengths.background() == 0);
}
