// SPDX-License-Identifier: Apache-2.0
#include "output_picture.hpp"

#include <filesystem>

#include "keikan/image/exr_file.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

bool is_exr(const std::string& image) {
    return std::filesystem::path(image).extension() == ".exr";
}
bool is_png(const std::string& image) {
    return image == "-" || std::filesystem::path(image).extension() == ".png";
}

}  // namespace

void require_writable(const OutputOptions& options) {
    if (!is_exr(options.image) && !is_png(options.image))
        throw InputError(options.image, "", "a picture's name ends in .png or .exr");
    if (options.aov && !is_exr(options.image))
        throw InputError(options.image, "", "--aov needs an .exr picture");
    const AtomicFile probe(options.image);  // unfinished: leaves nothing
}

void write_picture(const OutputOptions& options, const Scene& scene, RenderedPicture picture) {
    if (!is_exr(options.image))
        return write_png(options.image, picture.image,
                         options.bits == 16 ? PngBits::Sixteen : PngBits::Eight);
    ExrPicture exr = exr_picture(picture.image);
    exr.metadata = {
        {"software", "keikan " KEIKAN_VERSION},
        {"scene", scene.file.filename().string()},
        {"colour", "linear light, primaries of sRGB (ITU-R BT.709)"},
        {"filter", "box of one pixel: pixel (i, j) is the unit square [i, i+1] x [j, j+1], y down"}};
    if (options.aov) {
        exr.channels["background"] = std::move(picture.extra.background);
        exr.channels["object_id"] = std::move(picture.extra.object_id);
        exr.channels["depth"] = std::move(picture.extra.depth);
        exr.channels["flags"] = std::move(picture.extra.flags);
        exr.channels["water_samples"] = std::move(picture.extra.water_samples);
        exr.metadata["water_samples"] = "taken for the pixel's water, 0: none is drawn by rays";
        exr.metadata["background"] = "fraction of the pixel that no face covers";
        exr.metadata["object_id"] =
            "1 + position of the object that the largest part belongs to, 0: background";
        exr.metadata["depth"] = "of the largest part at its centroid [m], 0: background";
        exr.metadata["flags"] = "0: one face only, 1: divided by exact areas, 2: divided along the scanline";
    }
    write_exr(options.image, exr);
}

}  // namespace keikan
