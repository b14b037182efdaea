// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "keikan/compare/report.hpp"

namespace keikan::compare {

namespace {

/// Three digits, however small.
std::string short_number(double value) {
    if (value == 0) return "0";
    return value >= 0.001 ? fmt::format("{:.3g}", value) : fmt::format("{:.1e}", value);
}

std::string percent(double share) {
    return share == 0 ? "0" : fmt::format("{:.3g} %", 100 * share);
}

std::string ratio(double value) {
    return value >= 1 ? fmt::format("{:.2f}", value) : fmt::format("1/{:.1f}", 1 / value);
}

std::string methods_table(const Comparison& comparison) {
    std::string table = fmt::format(
        "| method | s, processor | s, wall | RMSE | largest | off by > 1/512 | RMSE, {0} | largest, {0} | "
        "off, {0} |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
        comparison.has_conductors ? "conductor pixels" : "all pixels");
    for (const MethodResult& r : comparison.methods)
        table += fmt::format("| `{}` | {:.3f} | {:.3f} | {} | {} | {} | {} | {} | {} |\n", name_of(r.method),
                             r.median.processor, r.median.wall, short_number(r.all.rmse),
                             short_number(r.all.largest), percent(r.all.off_share),
                             short_number(r.conductors.rmse), short_number(r.conductors.largest),
                             percent(r.conductors.off_share));
    return table;
}

std::string quality_table(const Comparison& comparison) {
    if (comparison.equal_quality.empty()) return "";
    std::string table =
        "\n| method | until | smallest N | its RMSE | off by > 1/512 | s, processor | kato's time |\n"
        "|---|---|---:|---:|---:|---:|---:|\n";
    for (const EqualQuality& q : comparison.equal_quality) {
        const Trial& t = q.reached ? *q.reached : q.last;
        table += fmt::format("| `{}` | {} | {} | {} | {} | {}{:.3f} | {} |\n", name_of(q.kind),
                             q.goal == Goal::KatoRmse ? "RMSE is not above kato's" : "nearly all right",
                             q.reached ? fmt::format("{}", t.count) : fmt::format("none to {}", t.count),
                             short_number(t.conductors.rmse), percent(t.conductors.off_share),
                             t.extrapolated ? "about " : "", t.seconds.processor, ratio(q.time_ratio));
    }
    return table;
}

std::string flicker_table(const Sequence& sequence) {
    std::string table = fmt::format(
        "\n| method | variation of {} conductors over {} frames | of the true one |\n|---|---:|---:|\n",
        sequence.conductors.size(), sequence.truth.light.size());
    const auto row = [&](const std::string& name, const Flicker& flicker) {
        table += fmt::format(
            "| {} | {} | {} |\n", name, short_number(flicker.total),
            sequence.truth.total > 0 ? fmt::format("{:.3f}", flicker.total / sequence.truth.total) : "");
    };
    row("exact", sequence.truth);
    for (const Flicker& flicker : sequence.methods)
        row(fmt::format("`{}`", name_of(flicker.method)), flicker);
    return table;
}

}  // namespace

std::string comparison_table(const std::string& scene, const Comparison& comparison,
                             const std::optional<Sequence>& sequence) {
    std::string text = fmt::format(
        "{}: {} faces, {} x {} pixels, {} of them with conductors, {} thread{}. Truth: {}. Median of {}.\n\n",
        scene, comparison.faces, comparison.size.width, comparison.size.height,
        comparison.conductor_pixel_count, comparison.threads, comparison.threads == 1 ? "" : "s",
        comparison.truth_is, comparison.methods.empty() ? 0 : comparison.methods[0].runs.size());
    text += methods_table(comparison) + quality_table(comparison);
    return sequence ? text + flicker_table(*sequence) : text;
}

}  // namespace keikan::compare
