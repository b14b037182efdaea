// SPDX-License-Identifier: GPL-3.0-or-later
#include "crosscheck/error_picture.hpp"

#include <catch2/catch.hpp>

#include "small_picture.hpp"

using namespace keikan;
using namespace keikan::crosscheck;

TEST_CASE("error_picture: brighter means more, black means none, red means wrong", "[crosscheck][report]") {
    Image<float> errors({60, 1});
    Image<std::uint8_t> wrong(errors.size());
    errors[{1, 0}] = 1e-18f;
    errors[{2, 0}] = 1e-15f;
    errors[{3, 0}] = 1e-12f;
    errors[{4, 0}] = 1e-12f;
    wrong[{4, 0}] = 1;
    const Image<Rgb> picture = error_picture(errors, wrong, scale_for(errors));
    CHECK(picture[{0, 0}] == Rgb{0, 0, 0});
    CHECK(picture[{1, 0}].g < picture[{2, 0}].g);
    CHECK(picture[{2, 0}].g < picture[{3, 0}].g);
    CHECK(picture[{4, 0}] == Rgb{1, 0, 0});
    CHECK(picture.height() > errors.height());  // the scale
}

TEST_CASE("scale_for: reaches to the largest error, at least to 1e-12", "[crosscheck][report]") {
    Image<float> errors({2, 1});
    CHECK(scale_for(errors).highest == -12);
    errors[{1, 0}] = 0.25f;
    CHECK(scale_for(errors).highest == 0);
    CHECK_THAT(error_legend({-18, -12}), Catch::Contains("1e-18") && Catch::Contains("1e-12"));
}
