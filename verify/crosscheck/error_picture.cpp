// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "keikan/image/srgb.hpp"

namespace keikan::crosscheck {
namespace {

constexpr int kBarHeight = 24;
constexpr Rgb kBlack{0, 0, 0}, kGrey{0.2f, 0.2f, 0.2f}, kWhite{1, 1, 1}, kRed{1, 0, 0};

/// Ten colours of viridis (S. van der Walt, N. Smith 2015, CC0) at equal distances, as sRGB codes. Its
/// lightness rises evenly, so equal steps of the logarithm look equal.
constexpr std::array<std::array<int, 3>, 10> kViridis = {{{68, 1, 84},
                                                          {72, 40, 120},
                                                          {62, 73, 137},
                                                          {49, 104, 142},
                                                          {38, 130, 142},
                                                          {31, 158, 137},
                                                          {53, 183, 121},
                                                          {110, 206, 88},
                                                          {181, 222, 43},
                                                          {253, 231, 37}}};

Rgb viridis(double t) {
    const double at = std::clamp(t, 0.0, 1.0) * (kViridis.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
    const double part = at - static_cast<double>(i);
    const auto channel = [&](std::size_t c) {
        const double code = (1 - part) * kViridis[i][c] + part * kViridis[i + 1][c];
        return static_cast<float>(linear_from_srgb(code / 255));
    };
    return {channel(0), channel(1), channel(2)};
}

Rgb colour_of(double log10_error, ErrorScale scale) {
    return viridis((log10_error - scale.lowest) / (scale.highest - scale.lowest));
}

/// Rows of 3 pixels for the digits 0 ... 9 and the minus sign.
constexpr std::array<std::string_view, 11> kGlyphs = {"####.##.##.####", ".#.##..#..#.###", "##...#.#.#..###",
                                                      "##...#.#...###.", "#.##.####..#..#", "####..##...###.",
                                                      ".###..####.####", "###..#.#..#..#.", "####.#####.####",
                                                      "####.####..###.", "......###......"};

void draw_text(Image<Rgb>& picture, int left, int top, const std::string& text, Rgb colour) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        const std::string_view glyph = kGlyphs[text[k] == '-' ? 10 : static_cast<std::size_t>(text[k] - '0')];
        for (int i = 0; i < 15; ++i) {
            const PixelIndex at{left + static_cast<int>(k) * 4 + i % 3, top + i / 3};
            const bool inside = at.x >= 0 && at.x < picture.width() && at.y < picture.height();
            if (glyph[static_cast<std::size_t>(i)] == '#' && inside) picture[at] = colour;
        }
    }
}

void draw_bar(Image<Rgb>& picture, int top, ErrorScale scale) {
    const int width = picture.width();
    const double decades = scale.highest - scale.lowest;
    for (int x = 0; x < width; ++x)
        for (int y = top + 2; y < top + 12; ++y)
            picture[{x, y}] = colour_of(scale.lowest + decades * (x + 0.5) / width, scale);
    for (int exponent = scale.lowest; exponent <= scale.highest; ++exponent) {
        const double at = (exponent - scale.lowest) / decades * (width - 1);
        const int x = std::clamp(static_cast<int>(std::lround(at)), 0, width - 1);
        for (int y = top + 12; y < top + 15; ++y) picture[{x, y}] = kWhite;
        const std::string text = std::to_string(exponent);
        const int text_width = static_cast<int>(text.size()) * 4 - 1;
        draw_text(picture, std::clamp(x - text_width / 2, 0, std::max(0, width - text_width)), top + 17, text,
                  kWhite);
    }
}

}  // namespace

ErrorScale scale_for(const Image<float>& errors) {
    const auto values = errors.values();
    const float largest = values.empty() ? 0 : *std::ranges::max_element(values);
    ErrorScale scale;
    if (largest > 0 && std::isfinite(largest))
        scale.highest = std::max(scale.highest, static_cast<int>(std::ceil(std::log10(largest))));
    return scale;
}

Image<Rgb> error_picture(const Image<float>& errors, const Image<std::uint8_t>& wrong, ErrorScale scale) {
    Image<Rgb> picture({errors.width(), errors.height() + kBarHeight}, kBlack);
    for (int y = 0; y < errors.height(); ++y)
        for (int x = 0; x < errors.width(); ++x) {
            const float error = errors[{x, y}];
            if (wrong[{x, y}])
                picture[{x, y}] = kRed;
            else if (error > 0)
                picture[{x, y}] = colour_of(std::log10(error), scale);
        }
    draw_bar(picture, errors.height(), scale);
    return picture;
}

std::string error_legend(ErrorScale scale) {
    return fmt::format(
        "error.png shows, for each pixel, the largest error of the areas of its faces and of the background, "
        "as a\n"
        "fraction of the pixel. Colour map viridis over the decimal logarithm: the bar below the picture "
        "runs from\n"
        "1e{} (dark violet, at the left) to 1e{} (yellow, at the right), with a tick and the exponent at "
        "every\n"
        "decade. Black: no error at all, or not asked about. Red: a disagreement, see summary.json.\n",
        scale.lowest, scale.highest);
}

Image<Rgb> flag_picture(const Image<Flag>& flags) {
    Image<Rgb> picture(flags.size());
    for (int y = 0; y < flags.height(); ++y)
        for (int x = 0; x < flags.width(); ++x) {
            const Flag flag = flags[{x, y}];
            picture[{x, y}] = flag == Flag::ExactAreas ? kWhite : flag == Flag::Scanline ? kGrey : kBlack;
        }
    return picture;
}

}  // namespace keikan::crosscheck
