// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>

#include "keikan/clip/visible_areas.hpp"
#include "keikan/scan/projected_faces.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// Which pixels get the exact division (paper 2.1).
enum class Extraction {
    Outline,  ///< every pixel in which more than one face, or a face and the background, can be seen
    /// Pixels met by an outline of a conductor, or by a near-horizontal edge of anything else. Edges count of
    /// faces that may be seen there, that is, all but those behind a face that covers the pixel. In any other
    /// pixel the lengths along the scanline through its centre are the weights.
    Paper,
};

struct ScanOptions {
    Extraction extraction = Extraction::Outline;
    /// Extraction::Paper: an edge is near-horizontal when |dy| < near_horizontal_slope |dx|.
    double near_horizontal_slope = 0.25;
    /// What divides the pixels. Engine::Splitting is asked only where faces may overlap; any other engine
    /// gets every pixel that is divided, and its areas are taken as they are: Engine::Published's can be
    /// wrong.
    Engine engine = Engine::Splitting;
};

struct ScanStatistics {
    std::uint64_t faces = 0;            ///< that the camera can see
    std::uint64_t divided_pixels = 0;   ///< by exact areas
    std::uint64_t scanline_pixels = 0;  ///< by lengths along the scanline
    std::uint64_t multi_object_pixels =
        0;  ///< divided pixels that show more than one object, or background too
    std::uint64_t parts = 0;
    std::uint64_t samples = 0;  ///< places looked at, by methods that sample: exact areas need none
    double seconds_project = 0, seconds_bin = 0, seconds_divide = 0;
};

/// Scans the picture in bands of rows and hands each band to `take`, in order from the top, one at a time.
/// Memory holds the projected faces and a few bands, not the picture.
///
/// Properties:
///   (1) Every pixel is in exactly one span or divided pixel.
///   (2) Under Extraction::Outline, the weights are visible_areas() of all `faces`, within its bounds (but
///       for Engine::Published); a span shows its face wholly.
///   (3) The bands are the same, byte for byte, for any number of threads.
/// Paper:    section 2, Fig. 1 (scan processing), and 3.1.
ScanStatistics scan_faces(const ProjectedFaces& faces, const Geometry& geometry, const Camera& camera,
                          const ScanOptions& options, const std::function<void(const ScanBand&)>& take);

}  // namespace keikan
