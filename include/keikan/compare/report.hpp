// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "keikan/compare/comparison.hpp"
#include "keikan/compare/sequence.hpp"

namespace keikan::compare {

/// Everything that a comparison has found, as Markdown: the methods, equal quality, and flicker if there is a
/// sequence.
std::string comparison_table(const std::string& scene, const Comparison& comparison,
                             const std::optional<Sequence>& sequence);

/// The same for programs. `scene` is named in it.
std::string comparison_json(const std::string& scene, const Comparison& comparison,
                            const std::optional<Sequence>& sequence);

/// RMSE in conductor pixels against processor seconds, both logarithmic: a line for each kind of method with
/// an N, a point for each other. What has no error stands on the lower edge. As SVG.
std::string comparison_plot(const std::string& scene, const Comparison& comparison);

/// Where the inset, and the frames, of the pictures are taken; not said: where most conductors are.
struct ReportOptions {
    std::optional<PixelIndex> inset = {};  ///< upper left corner
};

/// Writes into the folder, which is made where it is missing: compare.json, table.md, plot.svg, truth.png and
/// truth.exr (for --reference), a picture NAME.png and an error picture NAME.error.png for each method (':'
/// becomes '-'), inset.png (four times enlarged), and frames.png if there is a sequence.
///
/// Errors: InputError naming a file that cannot be written.
void write_comparison(const std::filesystem::path& folder, const std::string& scene,
                      const Comparison& comparison, const std::optional<Sequence>& sequence,
                      const ReportOptions& options);

}  // namespace keikan::compare
