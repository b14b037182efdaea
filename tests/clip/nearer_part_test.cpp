// SPDX-License-Identifier: Apache-2.0
#include "nearer_part.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>

#include "degenerate_pixels.hpp"

namespace {

using namespace keikan;
using namespace keikan::clip;
using Rational = boost::multiprecision::cpp_rational;

}  // namespace

TEST_CASE("NearnessDifference: equal planes differ by zero, and a plane one ulp off does not",
          "[clip][depth]") {
    const PixelIndex pixel{4095, 2159};
    const DepthPlane plane{0.1, -0.3, 7};
    DepthPlane other = plane;
    CHECK(NearnessDifference::exact(pixel, local_plane(pixel, plane), local_plane(pixel, other)).is_zero());
    other.b = std::nextafter(other.b, 1);
    CHECK_FALSE(
        NearnessDifference::exact(pixel, local_plane(pixel, plane), local_plane(pixel, other)).is_zero());
}

TEST_CASE("NearnessDifference: values and bounds hold against rational arithmetic", "[clip][depth][fuzz]") {
    test::Dice dice(31);
    const PixelIndex pixel{4095, 2159};
    for (int i = 0; i < 3000; ++i) {
        const double near = std::pow(10, -dice.between(0, 17));
        const DepthPlane p{dice.between(-1, 1), dice.between(-1, 1), dice.between(-4000, 4000)};
        const DepthPlane q{p.a + near * dice.between(-1, 1), p.b + near * dice.between(-1, 1),
                           p.c + near * dice.between(-4000, 4000)};
        const Point at{dice.number(0, 1 << 30) * 0x1p-30, dice.number(0, 1 << 30) * 0x1p-30};
        const Rational x = Rational(at.x) + pixel.x, y = Rational(at.y) + pixel.y;
        const Rational truth = (Rational(p.a) - Rational(q.a)) * x + (Rational(p.b) - Rational(q.b)) * y +
                               Rational(p.c) - Rational(q.c);
        const LocalPlane local_p = local_plane(pixel, p), local_q = local_plane(pixel, q);
        const NearnessDifference exact = NearnessDifference::exact(pixel, local_p, local_q);
        const NearnessDifference rough = NearnessDifference::rough(local_p, local_q);
        const auto off_by = [&truth](double value) {
            return std::abs(static_cast<double>(Rational(truth - Rational(value))));
        };
        REQUIRE(off_by(exact.at(at)) <=
                0x1p-53 * std::abs(static_cast<double>(truth)) + 0x1p-40 * exact.on_line());
        const Box spot{at.x, at.y, at.x, at.y};
        for (const NearnessDifference& d : {exact, rough}) {
            REQUIRE(off_by(d.largest(spot).value) <= d.largest(spot).error);
            REQUIRE(off_by(d.smallest(spot).value) <= d.smallest(spot).error);
        }
    }
}
