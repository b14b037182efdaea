// SPDX-License-Identifier: Apache-2.0
#include "keikan/compare/picture_error.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lettering.hpp"
#include "sheets.hpp"

using namespace keikan;
using namespace keikan::compare;

TEST_CASE("picture_error: root mean square over pixels and channels, the worst channel, the share off",
          "[compare]") {
    Image<Rgb> truth({4, 1}, Rgb{0.5f, 0.5f, 0.5f}), picture = truth;
    picture[{0, 0}].g = 0.75f;
    picture[{1, 0}].b = 0.5f + 0x1p-9f;  // 1/512 is not more than 1/512
    picture[{2, 0}].b = 0.5f + 0x1.8p-9f;
    const PictureError error = picture_error(picture, truth);
    CHECK(error.pixels == 4);
    CHECK(error.largest == 0.25);
    CHECK(error.off_share == 0.5);
    CHECK(error.rmse == Approx(std::sqrt((0.0625 + 0x1p-18 + 2.25 * 0x1p-18) / 12)).epsilon(1e-12));
    CHECK(picture_error(truth, truth).rmse == 0);
}

TEST_CASE("picture_error: values beyond what a display shows do not differ", "[compare]") {
    const Image<Rgb> truth({1, 1}, Rgb{1, 0, 7}), picture({1, 1}, Rgb{3, -1, 1});
    CHECK(picture_error(picture, truth).largest == 0);
    CHECK(picture_error(picture, truth).rmse_codes == 0);
}

TEST_CASE("picture_error: a code of 8 bits is an error of one", "[compare]") {
    // 12.92 linear / 255 below 0.0031308: one code is 1 / (255 * 12.92).
    const auto one = static_cast<float>(1 / (255 * 12.92));
    const Image<Rgb> truth({1, 1}, Rgb{}), picture({1, 1}, Rgb{one, one, one});
    CHECK(picture_error(picture, truth).rmse_codes == Approx(1).epsilon(1e-6));
}

TEST_CASE("picture_error: only the pixels asked for count; without any, nothing is wrong", "[compare]") {
    const Image<Rgb> truth({2, 1}, Rgb{}), picture({2, 1}, Rgb{1, 1, 1});
    Image<std::uint8_t> only({2, 1}, 0);
    CHECK(picture_error(picture, truth, &only).pixels == 0);
    CHECK(picture_error(picture, truth, &only).rmse == 0);
    only[{1, 0}] = 1;
    CHECK(picture_error(picture, truth, &only).pixels == 1);
    CHECK(picture_error(picture, truth, &only).rmse == 1);
}

TEST_CASE("busiest_window: where most of the mask is, never outside of the picture", "[compare]") {
    Image<std::uint8_t> mask({64, 32}, 0);
    for (int x = 41; x < 47; ++x) mask[{x, 21}] = 1;
    const Window window = busiest_window(mask, 4);
    CHECK((window.width == 8 && window.height == 4));
    CHECK(window.x == 40);
    CHECK((window.y <= 21 && 21 < window.y + window.height));
    CHECK(busiest_window(Image<std::uint8_t>({64, 32}, 0), 4) == Window{0, 0, 8, 4});
    CHECK(busiest_window(Image<std::uint8_t>({3, 2}, 1), 4) == Window{0, 0, 1, 1});
}

TEST_CASE("error_picture: black where nothing is wrong, the same colour for the same error", "[compare]") {
    Image<Rgb> truth({40, 4}, Rgb{0.25f, 0.25f, 0.25f}), picture = truth;
    picture[{1, 1}].r += 0.125f;
    picture[{5, 2}].g -= 0.125f;
    picture[{9, 3}].g += 0.5f;
    const Image<Rgb> errors = error_picture(picture, truth, "a");
    CHECK(errors[{0, 0}] == Rgb{});
    CHECK(errors[{1, 1}] == errors[{5, 2}]);
    CHECK(errors[{9, 3}].g > errors[{1, 1}].g);
    CHECK(errors.height() > truth.height());  // the scale
}

TEST_CASE("letter: what lies outside of the picture is left out", "[compare]") {
    Image<Rgb> image({12, 12});
    letter(image, -3, -2, "kato:paper", Rgb{1, 1, 1}, 3);
    letter(image, 11, 11, "0", Rgb{1, 1, 1});
    CHECK(image[{0, 1}] == Rgb{});          // the stem of the k is left of the picture
    CHECK(image[{0, 10}] == Rgb{1, 1, 1});  // its middle, two dots wide, reaches in
}
