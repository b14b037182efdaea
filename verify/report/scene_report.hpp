// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <vector>

#include "crosscheck/scene_check.hpp"
#include "report/page.hpp"
#include "report/scene_layers.hpp"

namespace keikan::report {

/// How many pixels a page of a scene shows in detail. Together they keep it below 10 MB for 1000 x 650
/// pixels.
inline constexpr std::size_t kWorstShown = 500;
inline constexpr std::size_t kDisagreeingShown = 1000;
inline constexpr std::size_t kSamplesOfKind = 16;

/// A finished check of a scene, and what it was a check of.
struct CheckedScene {
    const ProjectedFaces& faces;
    const crosscheck::SceneCheck& check;
    const crosscheck::CheckSummary& summary;  ///< all that was found, by `check` and beside it
    const crosscheck::SceneCheckOptions& options;
    const SceneLayers& layers;
    const Image<Rgb>& picture;
};

/// The worst pixels, those with a disagreement (the worst of them first, as far as there is room), and of
/// each PixelKind a sample that the seed chooses; by rows.
std::vector<PixelToShow> pixels_to_show(const CheckedScene& scene);

/// Fills in `errors`, `picture`, `pixels` and `junit`, and writes the page, and beside it picture.png (as the
/// scan and the renderer made it), error.png with error_legend.txt, and flags.png. Each appears whole or not
/// at all. Errors: InputError naming the file.
void write_scene_report(const std::filesystem::path& folder, Page page, const CheckedScene& scene);

}  // namespace keikan::report
