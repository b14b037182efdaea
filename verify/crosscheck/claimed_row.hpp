// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "disagreement.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan::crosscheck {

/// One row of the picture as the scan hands it to the renderer, pixel by pixel.
struct ClaimedRow {
    enum class Source : std::uint8_t {
        Missing,     ///< the band says nothing of this pixel
        OneFace,     ///< a span: one face, or the background, fills the pixel
        ExactAreas,  ///< divided by visible areas
        Scanline,    ///< divided by lengths along the scanline
    };
    struct Part {
        std::uint32_t face = 0;  ///< position in the projected faces
        double area = 0;
    };
    struct Pixel {
        Source source = Source::Missing;
        std::uint32_t part_begin = 0;  ///< into `parts`
        std::uint32_t part_end = 0;
        double background = 0;
    };
    std::vector<Pixel> pixels;
    std::vector<Part> parts;
    std::vector<Disagreement> faults;  ///< of form: pixels told twice or never, faces that do not exist

    std::span<const Part> parts_of(const Pixel& pixel) const {
        return std::span(parts).subspan(pixel.part_begin, pixel.part_end - pixel.part_begin);
    }
};

/// Row `y` of the picture, which must be in `band`.
ClaimedRow claimed_row(const ScanBand& band, int y, int width, const ProjectedFaces& faces);

/// Faces of the band that would be shaded with another plane, object or material than theirs.
std::vector<Disagreement> attribute_faults(const ScanBand& band, const Geometry& geometry,
                                           const ProjectedFaces& faces);

}  // namespace keikan::crosscheck
