// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth/layer_truth.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "keikan/support/parallel.hpp"
#include "oracle/exact_areas.hpp"
#include "truth/rounding.hpp"

using namespace keikan;
using namespace keikan::truth;

namespace {

/// Numbers in [0, 1) with 53 bits.
class Draw {
  public:
    explicit Draw(std::uint64_t seed) : state_(seed) {}
    double operator()() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

mpq_class area_of(const Ring& ring) {
    mpq_class twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point p = ring[i], q = ring[(i + 1) % ring.size()];
        twice += mpq_class(p.x) * mpq_class(q.y) - mpq_class(q.x) * mpq_class(p.y);
    }
    return abs(twice) / 2;
}

/// A ring that goes once around (x, y), its corners between `least` and `most` away.
Ring star(Draw& draw, double x, double y, double least, double most, int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i / corners, far = least + (most - least) * draw();
        ring.push_back({x + far * std::cos(angle), y + far * std::sin(angle)});
    }
    return ring;
}

using Sums = std::map<std::uint32_t, mpq_class>;

/// The exact coverage by each layer, summed over all pixels.
Sums sums_of(std::span<const Layer> layers, const Window& window, ImageSize size) {
    Sums sums;
    layer_coverage(layers, window, size, [&](PixelIndex, std::uint32_t layer, const mpq_class& coverage) {
        sums[layer] += coverage;
    });
    return sums;
}

Ring rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

}  // namespace

TEST_CASE("layer_coverage: summed over all pixels it is the area of the polygon, exactly",
          "[truth][layers]") {
    Draw draw(7);
    for (int round = 0; round < 4; ++round) {
        const Polygon with_holes{star(draw, 7.3, 5.1, 3, 5, 40),
                                 {star(draw, 6.1, 5.1, 0.2, 0.9, 7), star(draw, 8.6, 5.2, 0.1, 1.2, 9)}};
        const Polygon island{star(draw, 6.1, 5.1, 0.05, 0.15, 5), {}};
        const Layer layers[] = {{"shape", {with_holes, island}}};
        const mpq_class area = area_of(with_holes.outline) - area_of(with_holes.holes[0]) -
                               area_of(with_holes.holes[1]) + area_of(island.outline);
        // A pixel is 1/1.7 wide and 1/2.3 high; rows from the largest y down.
        const Window window{{-0.1, 11.3}, {14.6, -0.2}};
        const ImageSize size{25, 26};
        const mpq_class pixel =
            (mpq_class(14.6) - mpq_class(-0.1)) / 25 * ((mpq_class(11.3) - mpq_class(-0.2)) / 26);
        Sums sums = sums_of(layers, window, size);
        CHECK(sums[0] * pixel == area);
        CHECK(sums[0] + sums[Share::kBackground] == 25 * 26);
    }
}

TEST_CASE("layer_coverage: of two layers, what is seen of the second is the area of the difference",
          "[truth][layers]") {
    SECTION("by hand: a frame behind a bar") {
        const Layer layers[] = {{"bar", {{rectangle(0, 1.25, 4, 1.75), {}}}},
                                {"frame", {{rectangle(0.5, 0.5, 3.5, 3.5), {rectangle(1, 1, 3, 3)}}}}};
        Sums sums = sums_of(layers, {{0, 0}, {4, 4}}, {4, 4});
        CHECK(sums[0] == 2);
        CHECK(sums[1] == 9 - 4 - 2 * mpq_class(1, 4));  // the bar hides 1/2 x 1/2 of it on either side
    }
    SECTION("whichever is in front, both together cover the same") {
        Draw draw(11);
        for (int round = 0; round < 3; ++round) {
            const Layer a{"a", {{star(draw, 5, 5, 2, 4, 30), {star(draw, 5, 5, 0.5, 1.5, 12)}}}};
            const Layer b{"b", {{star(draw, 6, 4, 1, 3, 25), {}}, {star(draw, 1, 8, 0.3, 0.8, 6), {}}}};
            const Layer a_first[] = {a, b}, b_first[] = {b, a};
            const Window window{{0, 0}, {10, 10}};
            Sums one = sums_of(a_first, window, {10, 10}), other = sums_of(b_first, window, {10, 10});
            CHECK(one[0] == area_of(a.polygons[0].outline) - area_of(a.polygons[0].holes[0]));
            CHECK(other[0] == area_of(b.polygons[0].outline) + area_of(b.polygons[1].outline));
            CHECK(one[0] + one[1] == other[0] + other[1]);
            CHECK(one[1] < other[0]);  // something is hidden
        }
    }
}

TEST_CASE("layer_coverage: convex layers, pixel by pixel as the oracle of pixels says", "[truth][layers]") {
    Draw draw(3);
    for (int round = 0; round < 6; ++round) {
        std::vector<Layer> layers;
        std::vector<Ring> outlines;
        for (int i = 0; i < 6; ++i) {
            // Triangles on a grid of quarters: shared corners, corners on edges, edges along pixels.
            const auto quarter = [&] { return std::floor(draw() * 20) / 4; };
            Ring ring = {{quarter(), quarter()}, {quarter(), quarter()}, {quarter(), quarter()}};
            if (round >= 3)
                for (Point& p : ring) p = {p.x + draw() * 0.3, p.y - draw() * 0.3};
            layers.push_back({std::to_string(i), {{ring, {}}}});
            outlines.push_back(ring);
        }
        std::vector<FaceView> faces;
        for (std::size_t i = 0; i < outlines.size(); ++i)
            faces.push_back({static_cast<FaceId>(i), outlines[i], {}});
        std::map<std::pair<int, int>, Sums> found;
        layer_coverage(layers, {{0, 0}, {5, 5}}, {5, 5},
                       [&](PixelIndex p, std::uint32_t layer, const mpq_class& c) {
                           found[{p.x, p.y}][layer] = c;
                       });
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) {
                const auto exact = oracle::areas_by_rational_splitting({x, y}, faces, Nearness::InOrder);
                Sums expected;
                for (std::size_t i = 0; i < faces.size(); ++i)
                    if (exact.areas[i] != 0) expected[static_cast<std::uint32_t>(i)] = exact.areas[i];
                if (exact.background != 0) expected[Share::kBackground] = exact.background;
                CHECK(found[{x, y}] == expected);
            }
    }
}

TEST_CASE("layer_coverage: what a layer covers twice it covers once; rings may touch and cross",
          "[truth][layers]") {
    const Window window{{0, 0}, {4, 4}};
    const auto covered = [&](const std::vector<Polygon>& polygons) {
        const Layer layers[] = {{"", polygons}};
        return sums_of(layers, window, {4, 4})[0];
    };
    CHECK(covered({{rectangle(0, 0, 2, 2), {}}, {rectangle(1, 1, 3, 3), {}}}) == 7);
    CHECK(covered({{rectangle(0, 0, 2, 2), {}}, {rectangle(0, 0, 2, 2), {}}}) == 4);
    CHECK(covered({{rectangle(0, 0, 2, 2), {}}, {rectangle(2, 0, 4, 2), {}}}) == 8);
    CHECK(covered({{rectangle(0, 0, 4, 4), {rectangle(0, 1, 2, 3)}}}) == 12);  // the hole touches the outline
    CHECK(covered({{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}}) == 8);             // crosses itself
    CHECK(covered({{{{0, 0}, {4, 0}, {4, 0}, {0, 0}}, {}}}) == 0);             // no area
    CHECK(covered({{{}, {}}}) == 0);
    CHECK(covered({}) == 0);
}

TEST_CASE("layer_coverage: what lies outside of the window does not count", "[truth][layers]") {
    const Layer layers[] = {{"", {{rectangle(-1e6, 0.5, 1e6, 0.75), {}}}},
                            {"", {{{{-1e9, -1e9}, {1e9, -1e9}, {0.5, 1e9}}, {}}}}};
    const CoveragePicture picture = layer_coverage(layers, {{0, 0}, {2, 2}}, {2, 2});
    REQUIRE(picture.at(0, 0).size() == 2);
    CHECK(picture.at(0, 0)[0] == Share{0, 0.25f, 16384});
    CHECK(picture.at(0, 0)[1] == Share{1, 0.75f, 49151});
    CHECK(picture.at(1, 1).size() == 1);
    CHECK(picture.at(1, 1)[0] == Share{1, 1, 65535});
}

TEST_CASE("layer_coverage: rows begin at the window's first corner", "[truth][layers]") {
    const Layer layers[] = {{"low", {{rectangle(0, 0, 1, 1), {}}}}};
    CHECK(layer_coverage(layers, {{0, 0}, {2, 2}}, {2, 2}).at(0, 0)[0].matte == 0);
    CHECK(layer_coverage(layers, {{0, 2}, {2, 0}}, {2, 2}).at(0, 1)[0].matte == 0);
    CHECK(layer_coverage(layers, {{2, 2}, {0, 0}}, {2, 2}).at(1, 1)[0].matte == 0);
}

TEST_CASE("layer_coverage: the same for any number of threads", "[truth][layers]") {
    Draw draw(5);
    const Layer layers[] = {{"a", {{star(draw, 15, 15, 5, 14, 60), {}}}},
                            {"b", {{star(draw, 12, 17, 5, 11, 50), {}}}}};
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return layer_coverage(layers, {{0, 0}, {30, 30}}, {90, 90}).shares;
    };
    CHECK(with(1) == with(3));
}
