// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace keikan {

struct DemImport {
    std::filesystem::path source;                 ///< whatever GDAL reads; its first band
    std::filesystem::path grid;                   ///< the .png to write; the frame goes beside it as .json
    std::optional<std::string> srs;               ///< metric frame to reproject to, e.g. "EPSG:32725"
    std::optional<double> spacing_m;              ///< between samples
    std::optional<std::array<double, 4>> window;  ///< xmin, ymin, xmax, ymax in the metric frame
};

struct ImportedDem {
    int columns = 0;
    int rows = 0;
    std::string crs;
    double lowest_m = 0;
    double highest_m = 0;
    double height_step_m = 1;  ///< what one unit of the PNG is worth
    std::size_t voids = 0;
    bool resampled = false;
};

/// Converts an elevation model to a height grid in metres: 16-bit PNG and frame (docs/scene.md).
///
/// A model that already stands in a north-up frame of metres, and of which nothing else is asked, is copied
/// sample by sample. Otherwise it is reprojected with cubic interpolation, to `srs` or else to the UTM zone
/// (WGS 84) of its middle. Whole-numbered models that are not resampled keep their heights exactly; others
/// are rounded to the finest of 1, 2 or 5 times a power of ten (0.01 m at the finest) that 16 bits hold.
///
/// Both files appear whole or not at all.
///
/// Errors: InputError for a source that GDAL cannot read, that has no place on the Earth, whose heights are
/// in
///         units other than metres or feet, or whose window holds no height.
ImportedDem import_dem(const DemImport& request);

}  // namespace keikan
