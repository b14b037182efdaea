// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "keikan/compare/report.hpp"
#include "keikan/image/exr_file.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "sheets.hpp"

namespace keikan::compare {

namespace {

constexpr int kZoom = 4, kFrameZoom = 2;

std::string file_name(const baseline::Method& method) {
    std::string name = name_of(method);
    std::replace(name.begin(), name.end(), ':', '-');
    return name;
}

Window inset_window(const Comparison& comparison, const ReportOptions& options) {
    Window window = busiest_window(comparison.conductor_pixels, kZoom);
    if (!options.inset) return window;
    window.x = std::min(options.inset->x, comparison.size.width - window.width);
    window.y = std::min(options.inset->y, comparison.size.height - window.height);
    return window;
}

}  // namespace

void write_comparison(const std::filesystem::path& folder, const std::string& scene,
                      const Comparison& comparison, const std::optional<Sequence>& sequence,
                      const ReportOptions& options) {
    write_whole_file(folder / "compare.json", comparison_json(scene, comparison, sequence));
    write_whole_file(folder / "table.md", comparison_table(scene, comparison, sequence));
    write_whole_file(folder / "plot.svg", comparison_plot(scene, comparison));
    write_png(folder / "truth.png", comparison.truth);
    write_exr(folder / "truth.exr", exr_picture(comparison.truth));
    std::vector<LabelledPicture> pictures{{"exact", &comparison.truth}};
    for (const MethodResult& result : comparison.methods) {
        const std::string name = file_name(result.method);
        write_png(folder / (name + ".png"), result.picture);
        write_png(folder / (name + ".error.png"),
                  error_picture(result.picture, comparison.truth, name_of(result.method)));
        pictures.push_back({name_of(result.method), &result.picture});
    }
    const Window window = inset_window(comparison, options);
    write_png(folder / "inset.png", zoomed_sheet(pictures, window, kZoom, 3));
    if (sequence) write_png(folder / "frames.png", frames_sheet(*sequence, window, kFrameZoom));
}

}  // namespace keikan::compare
