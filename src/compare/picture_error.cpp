// SPDX-License-Identifier: Apache-2.0
#include "keikan/compare/picture_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "keikan/image/srgb.hpp"
#include "keikan/support/check.hpp"

namespace keikan::compare {

namespace {

std::array<double, 3> shown(Rgb c) {
    const auto within = [](float v) { return std::clamp(static_cast<double>(v), 0.0, 1.0); };
    return {within(c.r), within(c.g), within(c.b)};
}

}  // namespace

PictureError picture_error(const Image<Rgb>& picture, const Image<Rgb>& truth,
                           const Image<std::uint8_t>* only) {
    KEIKAN_CHECK(picture.size() == truth.size(), "pictures of different sizes are compared");
    PictureError error;
    double squares = 0, code_squares = 0;
    std::uint64_t off = 0;
    for (std::size_t i = 0; i < truth.values().size(); ++i) {
        if (only != nullptr && only->values()[i] == 0) continue;
        ++error.pixels;
        if (picture.values()[i] == truth.values()[i]) continue;
        const auto p = shown(picture.values()[i]), t = shown(truth.values()[i]);
        double worst = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = std::abs(p[c] - t[c]);
            const double codes = 255 * (srgb_from_linear(p[c]) - srgb_from_linear(t[c]));
            worst = std::max(worst, d);
            squares += d * d;
            code_squares += codes * codes;
        }
        error.largest = std::max(error.largest, worst);
        off += worst > kVisible;
    }
    if (error.pixels == 0) return error;
    const auto pixels = static_cast<double>(error.pixels);
    error.rmse = std::sqrt(squares / (3 * pixels));
    error.rmse_codes = std::sqrt(code_squares / (3 * pixels));
    error.off_share = static_cast<double>(off) / pixels;
    return error;
}

}  // namespace keikan::compare
