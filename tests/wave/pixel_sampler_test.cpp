// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/pixel_sampler.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <set>

#include "keikan/support/input_error.hpp"
#include "keikan/wave/counter_random.hpp"

using namespace keikan;

namespace {

using Integrand = std::function<double(Point)>;

struct Spread {
    double mean, variance;
};

constexpr int kRepeats = 4000;

/// Of the estimate of the integral, over many keys.
Spread spread(Sampler sampler, std::size_t count, const Integrand& f) {
    std::vector<Point> points;
    double sum = 0, squares = 0;
    for (int i = 0; i < kRepeats; ++i) {
        sample_points(sampler, count, random_key(i, 77, 1), points);
        double mean = 0;
        for (const Point p : points) mean += f(p);
        mean /= static_cast<double>(points.size());
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / kRepeats;
    return {mean, std::max(0.0, squares / kRepeats - mean * mean)};
}

/// A variance estimated from kRepeats values is known to sqrt(2 / kRepeats) = 2.2 % of itself where the
/// values are about normal; sums of few bounded terms are not far from it. Five times that.
constexpr double kVarianceKnown = 5 * 0.0224;

const Integrand kLinear = [](Point p) { return p.x; };
const Integrand kSquare = [](Point p) { return p.x * p.x; };
const Integrand kStep = [](Point p) { return p.x < 0.515625 ? 1.0 : 0.0; };  // 1/2 + 1/64
const Integrand kDisc = [](Point p) { return p.x * p.x + p.y * p.y < 0.64 ? 1.0 : 0.0; };
constexpr double kDiscArea = 0.64 * 3.14159265358979323846 / 4;
const Sampler kAll[] = {Sampler::Random, Sampler::Paper, Sampler::Haber, Sampler::Jittered, Sampler::Sobol};

}  // namespace

TEST_CASE("sample_points: every sampler is unbiased on smooth and broken integrands", "[wave][sampler]") {
    for (const Sampler sampler : kAll)
        for (const std::size_t count : {2u, 7u, 32u}) {
            INFO("sampler " << static_cast<int>(sampler) << ", " << count);
            const auto unbiased = [&](const Integrand& f, double expected) {
                const Spread found = spread(sampler, count, f);
                // Five standard errors, and rounding where there is no spread.
                CHECK(std::abs(found.mean - expected) <= 5 * std::sqrt(found.variance / kRepeats) + 1e-12);
            };
            unbiased(kLinear, 0.5);
            unbiased(kSquare, 1.0 / 3);
            unbiased(kStep, 0.515625);
            unbiased(kDisc, kDiscArea);
            unbiased([](Point p) { return p.x * p.y; }, 0.25);
        }
}

TEST_CASE("sample_points: variances on f = x are those of the theory", "[wave][sampler]") {
    const std::size_t n = 128;  // D = 8 for pairs
    CHECK(spread(Sampler::Random, n, kLinear).variance == Approx(1.0 / 12 / 128).epsilon(kVarianceKnown));
    // A pair's mean is its cell's centre: variance (1 - 1/64) / 12, 64 pairs. Twice Random's, nearly.
    CHECK(spread(Sampler::Paper, n, kLinear).variance ==
          Approx((1 - 1.0 / 64) / 12 / 64).epsilon(kVarianceKnown));
    CHECK(spread(Sampler::Haber, n, kLinear).variance < 1e-28);  // every pair's mean is exact
    // 121 cells, each 1/11 wide: 1 / (12 * 121) in each, divided by 121.
    CHECK(spread(Sampler::Jittered, n, kLinear).variance ==
          Approx(1.0 / 12 / 121 / 121).epsilon(kVarianceKnown));
    CHECK(spread(Sampler::Sobol, n, kLinear).variance < 1.0 / 12 / 128 / 128 / 64);
}

TEST_CASE("sample_points: variances on f = x^2 are those of the theory", "[wave][sampler]") {
    const std::size_t n = 128;
    CHECK(spread(Sampler::Random, n, kSquare).variance == Approx(4.0 / 45 / 128).epsilon(kVarianceKnown));
    // In a cell of width h about c: a pair gives c^2 + u^2 with variance h^4/180.
    CHECK(spread(Sampler::Haber, n, kSquare).variance ==
          Approx(std::pow(1.0 / 8, 4) / 180 / 64).epsilon(kVarianceKnown));
    // Alone: c^2 h^2 / 3 + h^4 / 180; the mean of c^2 over the cells is 1/3 - h^2/12.
    const double h2 = 1.0 / 121;
    CHECK(spread(Sampler::Jittered, n, kSquare).variance ==
          Approx(((1.0 / 3 - h2 / 12) * h2 / 3 + h2 * h2 / 180) / 121).epsilon(kVarianceKnown));
    // Pairs fall anywhere: variance of c^2 + u^2 over all cells, 64 of them. Var(c^2) = E c^4 - (E c^2)^2.
    const double h = 1.0 / 8;
    double c2 = 0, c4 = 0;
    for (int i = 0; i < 8; ++i) {
        const double c = (i + 0.5) * h;
        c2 += c * c / 8;
        c4 += c * c * c * c / 8;
    }
    CHECK(spread(Sampler::Paper, n, kSquare).variance ==
          Approx((c4 - c2 * c2 + std::pow(h, 4) / 180) / 64).epsilon(kVarianceKnown));
    CHECK(spread(Sampler::Sobol, n, kSquare).variance < 4.0 / 45 / 128 / 128 / 16);
}

TEST_CASE("sample_points: variances on a step are those of the theory", "[wave][sampler]") {
    const std::size_t n = 128;
    const double p = 0.515625;
    CHECK(spread(Sampler::Random, n, kStep).variance == Approx(p * (1 - p) / 128).epsilon(kVarianceKnown));
    // The step lies in a column of 8 cells, an eighth of the way: of a pair, one point is left of it with
    // probability 1/4.
    CHECK(spread(Sampler::Haber, n, kStep).variance ==
          Approx(8 * (0.25 * 0.75 / 4) / 64 / 64).epsilon(kVarianceKnown));
    // 0.515625 * 11 = 5.671875.
    CHECK(spread(Sampler::Jittered, n, kStep).variance ==
          Approx(11 * 0.671875 * 0.328125 / 121 / 121).epsilon(kVarianceKnown));
}

TEST_CASE("sample_points: on a disc, stratified samplers gain, and Sobol's is no worse than jittering",
          "[wave][sampler]") {
    const double random = spread(Sampler::Random, 128, kDisc).variance;
    CHECK(spread(Sampler::Haber, 128, kDisc).variance < 0.5 * random);
    CHECK(spread(Sampler::Jittered, 128, kDisc).variance < 0.25 * random);
    CHECK(spread(Sampler::Sobol, 128, kDisc).variance < 0.25 * random);
    CHECK(spread(Sampler::Paper, 128, kDisc).variance > 0.9 * random);
}

TEST_CASE("sample_points: the paper's counts of cells and points", "[wave][sampler]") {
    CHECK(paper_divisions(2) == 1);
    CHECK(paper_divisions(7) == 1);
    CHECK(paper_divisions(8) == 2);
    CHECK(paper_divisions(512) == 16);
    CHECK(paper_divisions(0) == 1);
    std::vector<Point> points;
    const auto count = [&](Sampler sampler, std::size_t n) {
        sample_points(sampler, n, 5, points);
        return points.size();
    };
    CHECK(count(Sampler::Random, 13) == 13);
    CHECK(count(Sampler::Sobol, 13) == 13);
    CHECK(count(Sampler::Paper, 13) == 12);
    CHECK(count(Sampler::Haber, 19) == 18);
    CHECK(count(Sampler::Jittered, 19) == 16);
    for (const Sampler sampler : kAll) CHECK(count(sampler, 0) >= 1);
}

TEST_CASE("sample_points: mirrored pairs share a cell and lie around its centre", "[wave][sampler]") {
    std::vector<Point> points;
    for (const Sampler sampler : {Sampler::Paper, Sampler::Haber}) {
        sample_points(sampler, 200, 9, points);  // D = 10
        for (std::size_t i = 0; i < points.size(); i += 2) {
            const Point p = points[i], q = points[i + 1];
            CHECK((p.x + q.x) / 2 * 10 - std::floor(p.x * 10) == Approx(0.5).epsilon(1e-12));
            CHECK((p.y + q.y) / 2 * 10 - std::floor(p.y * 10) == Approx(0.5).epsilon(1e-12));
        }
    }
}

TEST_CASE("sample_points: all points lie in the unit square and follow from the key alone",
          "[wave][sampler]") {
    std::vector<Point> points, again;
    for (const Sampler sampler : kAll) {
        sample_points(sampler, 300, 4, points);
        for (const Point p : points) {
            REQUIRE((p.x >= 0 && p.x <= 1));
            REQUIRE((p.y >= 0 && p.y <= 1));
        }
        sample_points(sampler, 300, 4, again);
        CHECK(points == again);
        sample_points(sampler, 300, 5, again);
        CHECK_FALSE(points == again);
    }
}

TEST_CASE("scrambled_sobol: every elementary interval of 2^m points holds one", "[wave][sampler]") {
    for (std::uint64_t key = 0; key < 20; ++key)
        for (const bool shuffled : {false, true})
            for (int m = 0; m <= 10; ++m)
                for (int a = 0; a <= m; ++a) {
                    std::set<std::pair<int, int>> filled;
                    for (std::uint32_t i = 0; i < (1u << m); ++i) {
                        const Point p = shuffled ? shuffled_sobol(i, key) : scrambled_sobol(i, key);
                        filled.insert(
                            {static_cast<int>(p.x * (1 << a)), static_cast<int>(p.y * (1 << (m - a)))});
                    }
                    REQUIRE(filled.size() == (1u << m));
                }
}

TEST_CASE("shuffled_sobol: paired with another key's points it fills four dimensions", "[wave][sampler]") {
    // The product of the deviations from the middle, over many keys, has the expectation 0: without
    // shuffling, point i would be tied to point i.
    double sum = 0, squares = 0;
    const int keys = 2000, count = 64;
    for (int key = 0; key < keys; ++key) {
        double mean = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Point p = scrambled_sobol(i, random_key(key, 0, 1));
            const Point q = shuffled_sobol(i, random_key(key, 0, 2));
            mean += (p.x - 0.5) * (q.x - 0.5) / count;
        }
        sum += mean;
        squares += mean * mean;
    }
    CHECK(std::abs(sum / keys) < 5 * std::sqrt(squares / keys / keys));
    // And the spread is about that of independent pairing, (1/12)^2 / 64.
    CHECK(squares / keys < 2.0 / 144 / 64);
}

TEST_CASE("CounterRandom: uniform numbers, a function of key and counter", "[wave][sampler]") {
    CounterRandom random(random_key(3, 4, 5));
    double sum = 0, squares = 0;
    const int n = 100'000;
    for (int i = 0; i < n; ++i) {
        const double u = random.uniform();
        REQUIRE((u >= 0 && u < 1));
        sum += u;
        squares += u * u;
    }
    CHECK(sum / n == Approx(0.5).margin(5 * std::sqrt(1.0 / 12 / n)));
    CHECK(squares / n == Approx(1.0 / 3).margin(5 * std::sqrt(4.0 / 45 / n)));
    CounterRandom first(random_key(3, 4, 5)), third(random_key(3, 4, 5), 2);
    first.bits();
    first.bits();
    CHECK(first.bits() == third.bits());
    CHECK(random_key(3, 4, 5) != random_key(4, 3, 5));
    CHECK(random_key(3, 4, 5) != random_key(3, 4, 6));
    CHECK(random_key(-1, 0, 0) != random_key(0, -1, 0));
}

TEST_CASE("sampler_of: knows its names", "[wave][sampler][input]") {
    CHECK(sampler_of("haber") == Sampler::Haber);
    CHECK(sampler_of("sobol") == Sampler::Sobol);
    CHECK_THROWS_AS(sampler_of("halton"), InputError);
}
