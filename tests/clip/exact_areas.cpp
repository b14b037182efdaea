// SPDX-License-Identifier: Apache-2.0
#include "exact_areas.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include "exact_reference.hpp"

namespace keikan::test {

std::vector<ExactArea> exact_areas(const PixelCase& pixel_case) {
    using Rational = boost::multiprecision::cpp_rational;
    const std::vector<FaceView> faces = pixel_case.faces();
    const auto truth =
        ExactReference<Rational>::visible_areas(pixel_case.pixel, faces, pixel_case.nearness());
    std::vector<ExactArea> areas;
    const auto add = [&areas](const Rational& area) {
        const auto high = static_cast<double>(area);
        areas.push_back({high, static_cast<double>(Rational(area - Rational(high)))});
    };
    for (const Rational& area : truth.areas) add(area);
    add(truth.background);
    return areas;
}

}  // namespace keikan::test
