// SPDX-License-Identifier: Apache-2.0
#include "keikan/water/slopes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "keikan/wave/pixel_sampler.hpp"

using namespace keikan;

namespace {

struct View {
    SlopeCovariance covariance;
    glm::dvec2 resolved;
    glm::dvec3 towards_viewer;
};

View view(double elevation, glm::dvec2 resolved = {0, 0}) {
    SlopeCovariance covariance;
    covariance.add({0.6, 0.8}, 0.02);
    covariance.add({1, 0}, 0.01);
    covariance.add({0, 1}, 0.004);
    return {
        covariance, resolved, {0.8 * std::cos(elevation), -0.6 * std::cos(elevation), std::sin(elevation)}};
}

/// The density, with the projection, from its definition without the factor 1/Z.
double unscaled(const View& v, glm::dvec2 z) {
    const SlopeCovariance& c = v.covariance;
    const double det = c.xx * c.yy - c.xy * c.xy, x = z.x - v.resolved.x, y = z.y - v.resolved.y;
    const double p = std::exp(-(c.yy * x * x - 2 * c.xy * x * y + c.xx * y * y) / (2 * det)) /
                     (2 * 3.14159265358979323846 * std::sqrt(det));
    return p * std::max(0.0, v.towards_viewer.z - v.towards_viewer.x * z.x - v.towards_viewer.y * z.y);
}

struct Moments {
    double whole = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
};

/// By the rectangle rule over nine standard deviations: exact to rounding but for the bend where slopes turn
/// away.
template <typename Density>
Moments integrated(const View& v, const Density& density) {
    Moments m;
    const int n = 1200;
    const double reach = 1.6, step = 2 * reach / n;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const glm::dvec2 z(v.resolved.x - reach + (i + 0.5) * step,
                               v.resolved.y - reach + (j + 0.5) * step);
            const double d = density(z) * step * step;
            m.whole += d;
            m.x += d * z.x;
            m.y += d * z.y;
            m.xx += d * z.x * z.x;
            m.yy += d * z.y * z.y;
            m.xy += d * z.x * z.y;
        }
    return m;
}

}  // namespace

TEST_CASE("inverse_normal: is the inverse of the distribution", "[water][slopes]") {
    for (double u = 1e-9; u < 1; u = u < 0.1 ? u * 3 : u + 0.0417)
        CHECK(std::erfc(-inverse_normal(u) / std::sqrt(2)) / 2 == Approx(u).epsilon(1e-7));
    CHECK(inverse_normal(0.5) == 0);
    CHECK(inverse_normal(0.975) == Approx(1.959963985).epsilon(1e-8));
}

TEST_CASE("SeenSlopes: slopes have the moments of their density, from above and at grazing angles",
          "[water][slopes]") {
    for (const View& v : {view(1.2), view(0.3), view(0.05), view(0.005), view(0.2, {-0.15, 0.1})}) {
        const SeenSlopes slopes(v.covariance, v.resolved, v.towards_viewer);
        const Moments exact = integrated(v, [&](glm::dvec2 z) { return unscaled(v, z); });
        Moments found;
        const std::uint32_t n = 1 << 15;
        for (std::uint32_t i = 0; i < n; ++i) {
            const Point u = scrambled_sobol(i, 3);
            const glm::dvec2 z = slopes.at(u.x, u.y);
            found.x += z.x / n;
            found.y += z.y / n;
            found.xx += z.x * z.x / n;
            found.yy += z.y * z.y / n;
            found.xy += z.x * z.y / n;
        }
        INFO("elevation " << std::asin(v.towards_viewer.z));
        // The quadrature is good to 1e-4 where slopes turn away within it; Sobol's points are, too.
        CHECK(found.x == Approx(exact.x / exact.whole).margin(5e-4));
        CHECK(found.y == Approx(exact.y / exact.whole).margin(5e-4));
        CHECK(found.xx == Approx(exact.xx / exact.whole).margin(2e-4));
        CHECK(found.yy == Approx(exact.yy / exact.whole).margin(2e-4));
        CHECK(found.xy == Approx(exact.xy / exact.whole).margin(2e-4));
    }
}

TEST_CASE("SeenSlopes: density times projection is the normalised density", "[water][slopes]") {
    for (const View& v : {view(1.2), view(0.3), view(0.05), view(0.2, {-0.15, 0.1})}) {
        const SeenSlopes slopes(v.covariance, v.resolved, v.towards_viewer);
        const double whole = integrated(v, [&](glm::dvec2 z) { return unscaled(v, z); }).whole;
        for (const glm::dvec2 z : {glm::dvec2(0, 0), glm::dvec2(-0.2, 0.1), glm::dvec2(0.05, 0.2)}) {
            const double projection =
                v.towards_viewer.z - v.towards_viewer.x * z.x - v.towards_viewer.y * z.y;
            if (projection <= 0) continue;
            CHECK(slopes.density_by_projection(z) * projection ==
                  Approx(unscaled(v, z) / whole).epsilon(2e-3));
        }
    }
}

TEST_CASE("SeenSlopes: without variance there is the resolved slope alone", "[water][slopes]") {
    const SeenSlopes slopes({}, {0.1, -0.2}, glm::normalize(glm::dvec3(1, 0, 1)));
    CHECK(slopes.at(0.3, 0.9) == glm::dvec2(0.1, -0.2));
    CHECK(slopes.density_by_projection({0.1, -0.2}) == 0);
}

TEST_CASE("SeenSlopes: every slope that is drawn faces the viewer", "[water][slopes]") {
    for (const View& v : {view(1.2), view(0.05), view(0.001)}) {
        const SeenSlopes slopes(v.covariance, v.resolved, v.towards_viewer);
        for (std::uint32_t i = 0; i < 4096; ++i) {
            const Point u = scrambled_sobol(i, 4);
            const glm::dvec2 z = slopes.at(u.x, u.y);
            REQUIRE(v.towards_viewer.z - v.towards_viewer.x * z.x - v.towards_viewer.y * z.y >= -1e-9);
        }
    }
}
