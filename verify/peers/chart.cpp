// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "peers/table.hpp"

namespace keikan::peers {
namespace {

constexpr double kRow = 34, kTop = 92, kNames = 150, kWidth = 300, kGap = 90;
constexpr double kWrongLeft = kNames, kSpeedLeft = kNames + kWidth + kGap;
constexpr std::array<const char*, 4> kColours = {"#fde0c5", "#f9a86f", "#dd5b4b", "#8f1d3f"};  // by kWrongBy
constexpr const char* kFailed = "#333333";

/// A logarithmic axis of whole decades across kWidth.
struct Axis {
    double left;
    int from;  ///< 10^from at the left end
    int to;
    double x(double value) const {
        const double along = (std::log10(value) - from) / (to - from);
        return left + kWidth * std::clamp(along, 0.0, 1.0);
    }
};

std::string text(double x, double y, const char* anchor, std::string_view words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

std::string bar(const Axis& axis, double value, double y, double height, const char* colour) {
    if (value <= 0) return "";
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                       axis.left, y, axis.x(value) - axis.left, height, colour);
}

std::string grid(const Axis& axis, double bottom, bool percent) {
    std::string lines;
    for (int decade = axis.from; decade <= axis.to; ++decade) {
        const double x = axis.x(std::pow(10.0, decade));
        lines += fmt::format("<path d=\"M{0:.1f} {1} V{2}\" stroke=\"#ddd\"/>\n", x, kTop - 6, bottom);
        const double value = std::pow(10.0, percent ? decade + 2 : decade);
        lines += text(x, bottom + 14, "middle",
                      percent ? fmt::format("{:g} %", value) : fmt::format("{:g}", value));
    }
    return lines;
}

std::string legend() {
    std::string items = text(kWrongLeft, 44, "start", "wrong by more than");
    double x = kWrongLeft + 122;
    for (std::size_t i = 0; i < kColours.size(); ++i, x += 66) {
        items += fmt::format("<rect x=\"{:.1f}\" y=\"34\" width=\"12\" height=\"12\" fill=\"{}\"/>\n", x,
                             kColours[i]);
        items += text(x + 16, 44, "start", kWrongByNames[i]);
    }
    items +=
        fmt::format("<rect x=\"{:.1f}\" y=\"34\" width=\"12\" height=\"12\" fill=\"{}\"/>\n", x, kFailed);
    return items + text(x + 16, 44, "start", "no answer: exception, crash, hang");
}

double share(std::uint64_t count, const Tally& tally) {
    return tally.pixels == 0 ? 0 : static_cast<double>(count) / static_cast<double>(tally.pixels);
}

std::string row(const Standing& s, double y, const Axis& wrong, const Axis& speed) {
    std::string row = text(kNames - 8, y + 16, "end", s.name);
    // Whoever is wrong by much is wrong by little too: the bars lie on each other.
    for (std::size_t i = 0; i < kColours.size(); ++i)
        row += bar(wrong, share(s.all.wrong[i], s.all), y, 16, kColours[i]);
    row += bar(wrong, share(s.all.failures(), s.all), y + 17, 6, kFailed);
    if (s.all.failures() == 0 && s.all.wrong[0] == 0) row += text(wrong.left + 4, y + 16, "start", "none");
    row += bar(speed, s.pixels_per_second(), y, 23, "#4a7fb0");
    const double tip = s.pixels_per_second() > 0 ? speed.x(s.pixels_per_second()) : speed.left;
    return row + text(tip + 4, y + 16, "start", fmt::format("{:.0f}", s.pixels_per_second()));
}

}  // namespace

std::string table_as_chart(std::span<const Standing> standings) {
    std::uint64_t pixels = 10;
    double fastest = 10, slowest = 1e9;
    for (const Standing& s : standings) {
        pixels = std::max(pixels, s.all.pixels);
        if (s.pixels_per_second() <= 0) continue;
        fastest = std::max(fastest, s.pixels_per_second());
        slowest = std::min(slowest, s.pixels_per_second());
    }
    // Half a pixel at the left end, so that a single one can be seen.
    const Axis wrong{kWrongLeft, static_cast<int>(std::floor(std::log10(0.5 / static_cast<double>(pixels)))),
                     0};
    const Axis speed{kSpeedLeft, static_cast<int>(std::floor(std::log10(std::min(slowest, fastest) / 2))),
                     static_cast<int>(std::ceil(std::log10(fastest)))};
    const double bottom = kTop + kRow * static_cast<double>(standings.size());
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
        "height=\"{1:g}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"#fff\"/>\n",
        kSpeedLeft + kWidth + 70, bottom + 30);
    svg +=
        text(kWrongLeft, 20, "start",
             fmt::format("Visible areas in {} pixels that are degenerate on purpose, against the exact ones",
                         pixels));
    svg += legend();
    svg += text(kWrongLeft, kTop - 14, "start", "share of the pixels");
    svg += text(kSpeedLeft, kTop - 14, "start", "pixels a second, one thread");
    svg += grid(wrong, bottom, true) + grid(speed, bottom, false);
    double y = kTop;
    for (const Standing& s : standings) {
        svg += row(s, y, wrong, speed);
        y += kRow;
    }
    return svg + "</svg>\n";
}

}  // namespace keikan::peers
