// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "keikan/compare/report.hpp"

namespace keikan::compare {

namespace {

using Kind = baseline::Method::Kind;

constexpr double kWidth = 760, kHeight = 500;
constexpr double kLeft = 74, kRight = 620, kTop = 62, kBottom = 436;

/// Okabe and Ito's colours, light and dark, told apart by the colour-blind; every line is named at its end,
/// too.
constexpr std::string_view kStyle = R"(<style>
.card { fill: #ffffff } text { font-family: 'DejaVu Sans', Verdana, Arial, sans-serif; font-size: 12px; fill: #24292f }
.soft { fill: #57606a } .grid { stroke: #d0d7de; stroke-width: 1 } .title { font-size: 15px }
.lead { stroke: #57606a; stroke-width: 1 } .line { fill: none; stroke-width: 2 } .late { stroke-dasharray: 4 3 } .dot { stroke: none }
.k0 { stroke: #0072b2; fill: #0072b2 } .k1 { stroke: #d55e00; fill: #d55e00 } .k2 { stroke: #009e73; fill: #009e73 }
.k3 { stroke: #aa4499; fill: #aa4499 } .k4 { stroke: #24292f; fill: #24292f }
path.line { fill: none }
@media (prefers-color-scheme: dark) {
.card { fill: #1b2027 } text { fill: #e6edf3 } .soft { fill: #a8b3bf } .grid { stroke: #3a424c } .lead { stroke: #a8b3bf }
.k0 { stroke: #56b4e9; fill: #56b4e9 } .k1 { stroke: #ff8c42; fill: #ff8c42 } .k2 { stroke: #35c79b; fill: #35c79b }
.k3 { stroke: #e08bd0; fill: #e08bd0 } .k4 { stroke: #e6edf3; fill: #e6edf3 }
}
</style>
)";

struct Dot {
    std::string name;
    double seconds = 0;
    double error = 0;
    bool extrapolated = false;
};

struct Line {
    std::string name;
    int colour = 0;
    std::vector<Dot> dots;
};

/// A logarithmic axis of whole decades.
struct Axis {
    int from = 0;
    int to = 1;
    double at_from = 0;
    double at_to = 1;
    double at(double value) const {
        const double along = value > 0 ? (std::log10(value) - from) / (to - from) : 0;
        return at_from + std::clamp(along, 0.0, 1.0) * (at_to - at_from);
    }
};

Axis axis_over(const std::vector<double>& values, double at_from, double at_to) {
    double least = HUGE_VAL, largest = 0;
    for (const double v : values)
        if (v > 0) least = std::min(least, v), largest = std::max(largest, v);
    if (largest == 0) least = largest = 1;
    Axis axis{static_cast<int>(std::floor(std::log10(least))),
              static_cast<int>(std::ceil(std::log10(largest))), at_from, at_to};
    axis.to = std::max(axis.to, axis.from + 1);
    return axis;
}

std::vector<Line> lines_of(const Comparison& comparison) {
    std::vector<Line> lines;
    constexpr std::array kKinds{Kind::MultiScan, Kind::Orthogonal, Kind::Grid, Kind::Random};
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
        Line line{name_of(kKinds[k]), static_cast<int>(k), {}};
        std::map<int, Dot> by_count;  // medians of several runs go before single ones
        for (const MethodResult& r : comparison.methods)
            if (r.method.kind == kKinds[k])
                by_count[r.method.count] = {std::to_string(r.method.count), r.median.processor,
                                            r.conductors.rmse, false};
        for (const Comparison::Trials& trials : comparison.trials)
            if (trials.kind == kKinds[k])
                for (const Trial& t : trials.trials)
                    by_count.try_emplace(t.count, Dot{std::to_string(t.count), t.seconds.processor,
                                                      t.conductors.rmse, t.extrapolated});
        for (const auto& [count, dot] : by_count) line.dots.push_back(dot);
        if (!line.dots.empty()) lines.push_back(std::move(line));
    }
    for (const MethodResult& r : comparison.methods)
        if (!r.method.has_count())
            lines.push_back({name_of(r.method), 4, {{"", r.median.processor, r.conductors.rmse, false}}});
    return lines;
}

std::string text(double x, double y, std::string_view words, std::string_view anchor = "start",
                 std::string_view style = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>\n", x, y,
                       anchor, style, words);
}

std::string grid(const Axis& x, const Axis& y) {
    std::string drawn;
    const auto value = [](int decade) {
        return decade >= -3 ? fmt::format("{:g}", std::pow(10.0, decade)) : fmt::format("1e{}", decade);
    };
    for (int d = x.from; d <= x.to; ++d) {
        const double at = x.at(std::pow(10.0, d));
        drawn += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1} V{2}\"/>\n", at, kTop, kBottom);
        drawn += text(at, kBottom + 18, value(d), "middle");
    }
    for (int d = y.from; d <= y.to; ++d) {
        const double at = y.at(std::pow(10.0, d));
        drawn += fmt::format("<path class=\"grid\" d=\"M{1} {0:.1f} H{2}\"/>\n", at, kLeft, kRight);
        drawn += text(kLeft - 8, at + 4, d == y.from ? "0" : value(d), "end");
    }
    return drawn;
}

std::string drawn(const Line& line, const Axis& x, const Axis& y) {
    std::string out;
    for (std::size_t i = 1; i < line.dots.size(); ++i)
        out +=
            fmt::format("<path class=\"line k{}{}\" d=\"M{:.1f} {:.1f} L{:.1f} {:.1f}\"/>\n", line.colour,
                        line.dots[i].extrapolated ? " late" : "", x.at(line.dots[i - 1].seconds),
                        y.at(line.dots[i - 1].error), x.at(line.dots[i].seconds), y.at(line.dots[i].error));
    for (const Dot& dot : line.dots)
        out += fmt::format("<circle class=\"dot k{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", line.colour,
                           x.at(dot.seconds), y.at(dot.error), line.dots.size() == 1 ? 5 : 3);
    return out;
}

struct Box {
    double left = 0, right = 0, top = 0, bottom = 0;
    bool holds(double x, double y) const { return x > left && x < right && y > top && y < bottom; }
    bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// Whether any dot, or any place along a line, lies in the box.
bool drawn_over(const Box& box, const std::vector<Line>& lines, const Axis& x, const Axis& y) {
    constexpr int kSteps = 32;
    for (const Line& line : lines)
        for (std::size_t i = 0; i < line.dots.size(); ++i) {
            const Dot &p = line.dots[i], &q = line.dots[std::min(i + 1, line.dots.size() - 1)];
            for (int k = 0; k < kSteps; ++k) {
                const double along = static_cast<double>(k) / kSteps;
                if (box.holds(x.at(p.seconds) + along * (x.at(q.seconds) - x.at(p.seconds)),
                              y.at(p.error) + along * (y.at(q.error) - y.at(p.error))))
                    return true;
            }
        }
    return false;
}

/// Names at the right of the lines' ends; where something stands there already, higher or lower, and a thin
/// line leads to the end.
std::string names(std::vector<Line> lines, const Axis& x, const Axis& y) {
    const auto end_of = [&](const Line& line) {
        return std::pair(y.at(line.dots.back().error), x.at(line.dots.back().seconds));
    };
    std::sort(lines.begin(), lines.end(),
              [&](const Line& a, const Line& b) { return end_of(a) > end_of(b); });
    std::vector<Box> taken;
    std::string out;
    for (const Line& line : lines) {
        const Dot& last = line.dots.back();
        const std::string words = last.name.empty() ? line.name : line.name + ":" + last.name;
        const auto [end_y, end_x] = end_of(line);
        Box box;
        double down = 0;
        for (const double step : {0, -16, 16, -32, 32, -48, 48}) {
            down = step;
            const double foot = end_y + 4 + down;
            box = {end_x + 7, end_x + 10 + 7.5 * static_cast<double>(words.size()), foot - 11, foot + 3};
            const bool inside = box.top > kTop - 8 && box.bottom < kBottom + 8;
            const bool free =
                std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); });
            if (inside && free && !drawn_over(box, lines, x, y)) break;
        }
        taken.push_back(box);
        if (down != 0)
            out += fmt::format("<path class=\"lead\" d=\"M{:.1f} {:.1f} L{:.1f} {:.1f}\"/>\n", end_x, end_y,
                               end_x + 8, end_y + down);
        out += text(end_x + 10, end_y + 4 + down, words);
    }
    return out;
}

}  // namespace

std::string comparison_plot(const std::string& scene, const Comparison& comparison) {
    const std::vector<Line> lines = lines_of(comparison);
    std::vector<double> seconds, errors;
    for (const Line& line : lines)
        for (const Dot& dot : line.dots) {
            seconds.push_back(dot.seconds);
            // An error of a float's rounding is none: it must not stretch the axis.
            if (dot.error > 1e-7) errors.push_back(dot.error);
        }
    const Axis x = axis_over(seconds, kLeft, kRight);
    Axis y = axis_over(errors, kBottom, kTop);
    --y.from;  // the lowest decade is for what has no error
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n",
        kWidth, kHeight);
    svg += kStyle;
    svg += fmt::format("<rect class=\"card\" width=\"{}\" height=\"{}\" rx=\"8\"/>\n", kWidth, kHeight);
    svg += text(kLeft, 26, fmt::format("{}: error against time", scene), "start", "title");
    svg += text(kLeft, 46,
                fmt::format("RMSE in {}, linear light; dashed: seconds extrapolated",
                            comparison.has_conductors ? "conductor pixels" : "all pixels"),
                "start", "soft");
    svg += text((kLeft + kRight) / 2, kBottom + 42, "processor seconds of the picture", "middle", "soft");
    svg += grid(x, y);
    for (const Line& line : lines) svg += drawn(line, x, y);
    return svg + names(lines, x, y) + "</svg>\n";
}

}  // namespace keikan::compare
