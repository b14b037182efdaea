// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "keikan/render/render_scene.hpp"

namespace keikan {

/// What `render` and `shade` write, and where.
struct OutputOptions {
    std::string image;  ///< .png, .exr, or "-" for a PNG on standard output
    int bits = 8;       ///< of a PNG
    bool aov = false;   ///< channels background, object_id, depth, flags in an OpenEXR file
};

/// Refuses options that do not fit together, and a folder that is missing, before any work is done.
/// Errors: InputError.
void require_writable(const OutputOptions& options);

/// Errors: InputError naming the file.
void write_picture(const OutputOptions& options, const Scene& scene, RenderedPicture picture);

}  // namespace keikan
