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
.line { fill: none; stroke-width: 2 } .late { stroke-dasharray: 4 3 } .dot { stroke: none }
.k0 { stroke: #0072b2; fill: #0072b2 } .k1 { stroke: #d55e00; fill: #d55e00 } .k2 { stroke: #009e73; fill: #009e73 }
.k3 { stroke: #aa4499; fill: #aa4499 } .k4 { stroke: #24292f; fill: #24292f }
path.line { fill: none }
@media (prefers-color-scheme: dark) {
.card { fill: #1b2027 } text { fill: #e6edf3 } .soft { fill: #a8b3bf } .grid { stroke: #3a424c }
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

/// Names at the right of the lines' ends, moved apart where they would stand on each other.
std::string names(const std::vector<Line>& lines, const Axis& x, const Axis& y) {
    constexpr double kApart = 15;
    struct Name {
        double x, y;
        std::string words;
    };
    std::vector<Name> all;
    for (const Line& line : lines) {
        const Dot& last = line.dots.back();
        all.push_back({x.at(last.seconds) + 9, y.at(last.error) + 4,
                       last.name.empty() ? line.name : line.name + ":" + last.name});
    }
    std::sort(all.begin(), all.end(), [](const Name& a, const Name& b) { return a.y > b.y; });
    std::string out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            if (std::abs(all[i].x - all[j].x) < 110 && std::abs(all[i].y - all[j].y) < kApart)
                all[i].y = all[j].y - kApart;
        out += text(all[i].x, all[i].y, all[i].words);
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
