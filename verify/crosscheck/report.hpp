// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

#include "keikan/image/image.hpp"
#include "scene_check.hpp"

namespace keikan::crosscheck {

/// Makes the folder for a report, with the folders above it.
/// Errors: InputError naming the folder, so that it shows before hours of checking.
void make_report_folder(const std::filesystem::path& folder);

/// Writes picture.png (as the scan and the renderer made it), error.png with error_legend.txt, flags.png and
/// summary.json into `folder`. Each appears whole or not at all.
/// Errors: InputError naming the file.
void write_report(const std::filesystem::path& folder, const Image<Rgb>& picture, const SceneCheck& check,
                  const std::string& summary);

}  // namespace keikan::crosscheck
