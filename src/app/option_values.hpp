// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/model/pixel.hpp"
#include "keikan/scan/scan_scene.hpp"
#include "keikan/scene/material.hpp"

namespace CLI {
class App;
}

namespace keikan {

/// "1000x650" as columns and rows; nothing for an empty text (the scene decides).
/// Errors: InputError where it is not of that form, or holds no pixel or more than 2^28.
std::optional<ImageSize> picture_size(const std::string& text);

/// "412,77" as a pixel of a picture of this size. Errors: InputError.
PixelIndex pixel_of(const std::string& text, ImageSize size, const std::string& option = "--at");

void add_shadows_option(CLI::App& app, std::string& shadows);
/// "off", "hard" or "soft"; nothing for an empty text (the scene decides). Errors: InputError.
std::optional<Shadows> shadows_of(const std::string& text);

/// "outline" or "paper". Errors: InputError.
Extraction extraction_of(const std::string& text);

/// "splitting", "traversal" or "published". Errors: InputError.
Engine engine_of(const std::string& engine);

/// The same, but for "published", whose areas need not add up to what a scan file promises. Errors:
/// InputError.
Engine engine_of_scan_file(const std::string& engine);

}  // namespace keikan
