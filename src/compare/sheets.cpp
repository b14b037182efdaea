// SPDX-License-Identifier: Apache-2.0
#include "sheets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lettering.hpp"

namespace keikan::compare {

namespace {

constexpr int kGap = 6, kLabel = 24;
constexpr Rgb kPaper{0.9f, 0.9f, 0.9f}, kInk{0.02f, 0.02f, 0.02f};

void put_zoomed(const Image<Rgb>& picture, const Window& window, int zoom, int left, int top,
                Image<Rgb>& sheet) {
    for (int y = 0; y < window.height * zoom; ++y)
        for (int x = 0; x < window.width * zoom; ++x)
            sheet[{left + x, top + y}] = picture[{window.x + x / zoom, window.y + y / zoom}];
}

/// Errors of 2^-kOctaves and less are black.
constexpr double kOctaves = 12;

/// Colours along the scale: dark to light, so that it can be read without colours, too.
Rgb scale_colour(double along) {
    constexpr std::array<Rgb, 6> kStops{Rgb{0, 0, 0},          {0.02f, 0.04f, 0.3f}, {0.3f, 0.02f, 0.35f},
                                        {0.75f, 0.12f, 0.08f}, {0.95f, 0.6f, 0.06f}, {1, 1, 0.9f}};
    const double place = std::clamp(along, 0.0, 1.0) * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const auto share = static_cast<float>(place - static_cast<double>(below));
    return (1 - share) * kStops[below] + share * kStops[below + 1];
}

Rgb colour_of_error(double error) {
    return error > 0 ? scale_colour(1 + std::log2(error) / kOctaves) : Rgb{};
}

}  // namespace

Window busiest_window(const Image<std::uint8_t>& mask, int zoom) {
    Window best{0, 0, std::max(mask.width() / (2 * zoom), 1), std::max(mask.height() / (2 * zoom), 1)};
    // Sums of the mask above and to the left of each corner.
    const auto stride = static_cast<std::size_t>(mask.width()) + 1;
    std::vector<std::uint32_t> sums(stride * (static_cast<std::size_t>(mask.height()) + 1), 0);
    const auto sum = [&](int x, int y) -> std::uint32_t& {
        return sums[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)];
    };
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            sum(x + 1, y + 1) = sum(x, y + 1) + sum(x + 1, y) - sum(x, y) + mask[{x, y}];
    std::uint32_t most = 0;
    for (int y = 0; y + best.height <= mask.height(); y += 4)
        for (int x = 0; x + best.width <= mask.width(); x += 4) {
            const std::uint32_t held = sum(x + best.width, y + best.height) - sum(x, y + best.height) -
                                       sum(x + best.width, y) + sum(x, y);
            if (held > most) most = held, best.x = x, best.y = y;
        }
    return best;
}

Image<Rgb> zoomed_sheet(std::span<const LabelledPicture> pictures, const Window& window, int zoom,
                        int columns) {
    const int count = static_cast<int>(pictures.size());
    columns = std::min(columns, std::max(count, 1));
    const int rows = (count + columns - 1) / columns;
    const int width = window.width * zoom + kGap, height = window.height * zoom + kLabel;
    Image<Rgb> sheet({columns * width + kGap, rows * height + kGap}, kPaper);
    for (int i = 0; i < count; ++i) {
        const int left = kGap + i % columns * width, top = i / columns * height;
        letter(sheet, left, top + 4, pictures[static_cast<std::size_t>(i)].label, kInk, 2);
        put_zoomed(*pictures[static_cast<std::size_t>(i)].picture, window, zoom, left, top + kLabel, sheet);
    }
    return sheet;
}

Image<Rgb> frames_sheet(const Sequence& sequence, const Window& window, int zoom) {
    const int frames = static_cast<int>(sequence.truth.light.size());
    const int rows = static_cast<int>(sequence.methods.size());
    const int width = window.width * zoom + kGap, height = window.height * zoom + kLabel;
    Image<Rgb> sheet({frames * width + kGap, rows * height + kGap}, kPaper);
    for (int row = 0; row < rows; ++row) {
        const Flicker& flicker = sequence.methods[static_cast<std::size_t>(row)];
        letter(sheet, kGap, row * height + 4, name_of(flicker.method), kInk, 2);
        for (int frame = 0; frame < frames; ++frame)
            put_zoomed(flicker.frames[static_cast<std::size_t>(frame)], window, zoom, kGap + frame * width,
                       row * height + kLabel, sheet);
    }
    return sheet;
}

Image<Rgb> error_picture(const Image<Rgb>& picture, const Image<Rgb>& truth, const std::string& label) {
    constexpr int kScaleHeight = 42 + kLabel;  // a line for the scale's numbers, one for the label
    const int width = picture.width(), height = picture.height();
    Image<Rgb> errors({width, height + kScaleHeight}, kPaper);
    const auto off = [](float p, float q) {
        return std::abs(static_cast<double>(std::clamp(p, 0.0f, 1.0f)) -
                        static_cast<double>(std::clamp(q, 0.0f, 1.0f)));
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb p = picture[{x, y}], q = truth[{x, y}];
            errors[{x, y}] = colour_of_error(std::max({off(p.r, q.r), off(p.g, q.g), off(p.b, q.b)}));
        }
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < 14; ++y)
            errors[{x, height + y}] = scale_colour(static_cast<double>(x) / std::max(width - 1, 1));
    for (const int octave : {12, 9, 6, 3}) {
        const int x = static_cast<int>((1 - octave / kOctaves) * (width - 1));
        letter(errors, x + (octave == 12 ? 2 : -12), height + 20, "1/" + std::to_string(1 << octave), kInk,
               2);
    }
    letter(errors, width - 14, height + 20, "1", kInk, 2);
    letter(errors, 2, height + 20 + kLabel, label, kInk, 2);
    return errors;
}

}  // namespace keikan::compare
