// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace keikan {
namespace {

constexpr double kMargin = 0.5;   ///< around the pixel, in pixels
constexpr int kCellSide = 320;    ///< of one drawing, in units of the picture
constexpr int kTitleHeight = 20;  ///< above it
constexpr std::size_t kColumns = 8;
constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#f0e442"};

/// The part of `ring` on the side of `bound` where factor * coordinate <= factor * bound. For the eye:
/// rounded.
Ring cut(const Ring& ring, double Point::*coordinate, double factor, double bound) {
    Ring rest;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        const double from = factor * (a.*coordinate - bound), to = factor * (b.*coordinate - bound);
        if (from <= 0) rest.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
            const double t = 1 / (1 - to / from);  // ends may be 1e300 away: no product of them
            rest.push_back({a.x * (1 - t) + b.x * t, a.y * (1 - t) + b.y * t});
        }
    }
    return rest;
}

/// The ring pixel-local, cut to what is drawn.
Ring drawn_part(const Ring& ring, PixelIndex pixel) {
    Ring part;
    for (const Point p : ring) part.push_back({p.x - pixel.x, p.y - pixel.y});
    part = cut(part, &Point::x, 1, 1 + kMargin);
    part = cut(part, &Point::x, -1, -kMargin);
    part = cut(part, &Point::y, 1, 1 + kMargin);
    return cut(part, &Point::y, -1, -kMargin);
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '<')
            safe += "&lt;";
        else if (c == '&')
            safe += "&amp;";
        else
            safe += static_cast<unsigned char>(c) < ' ' ? '?' : c;
    }
    return safe;
}

std::string polygon_drawing(const Ring& part, std::size_t number) {
    if (part.empty()) return "";
    const char* const colour = kColours[number % kColours.size()];
    std::string points;
    Point middle;
    for (const Point p : part) {
        points += fmt::format("{:.6g},{:.6g} ", p.x, p.y);
        middle = {middle.x + p.x / static_cast<double>(part.size()),
                  middle.y + p.y / static_cast<double>(part.size())};
    }
    points.pop_back();
    return fmt::format(R"(<polygon points="{}" fill="{}" fill-opacity="0.6" stroke="{}"/>)"
                       "\n"
                       R"(<text x="{:.6g}" y="{:.6g}" font-size="0.07" stroke="none">{}</text>)"
                       "\n",
                       points, colour, colour, middle.x, middle.y, number);
}

std::string drawing(const PixelCase& pixel_case, int left, int top) {
    std::string text = fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"12\">{}{}</text>\n"
        "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">\n"
        "<g stroke-width=\"0.006\" stroke-linejoin=\"round\">\n"
        "<rect width=\"1\" height=\"1\" fill=\"#eeeeee\" stroke=\"#444444\"/>\n",
        left + 4, top + 15, escaped(pixel_case.id), pixel_case.depth ? " (by depth)" : "", left,
        top + kTitleHeight, kCellSide, kCellSide, -kMargin, -kMargin, 1 + 2 * kMargin, 1 + 2 * kMargin);
    for (std::size_t i = pixel_case.polygons.size(); i-- > 0;)
        text += polygon_drawing(drawn_part(pixel_case.polygons[i], pixel_case.pixel), i);
    return text + "</g>\n</svg>\n";
}

}  // namespace

std::string svg_from_cases(std::span<const PixelCase> cases) {
    const std::size_t columns = std::clamp<std::size_t>(cases.size(), 1, kColumns);
    const std::size_t rows = (cases.size() + columns - 1) / columns;
    constexpr int kCellHeight = kCellSide + kTitleHeight;
    const auto width = columns * kCellSide, height = rows * kCellHeight;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\">\n",
        width, height);
    for (std::size_t i = 0; i < cases.size(); ++i)
        text += drawing(cases[i], static_cast<int>(i % columns) * kCellSide,
                        static_cast<int>(i / columns) * kCellHeight);
    return text + "</svg>\n";
}

}  // namespace keikan
