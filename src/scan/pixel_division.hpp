// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "closed_layer.hpp"
#include "faces_apart.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/scan/scan_scene.hpp"
#include "scanline_lengths.hpp"
#include "tile_candidates.hpp"

namespace keikan {

/// What all pixels of a scan have in common.
struct ScanQuestion {
    const ProjectedFaces& faces;
    const std::vector<FaceFacts>& facts;
    const FaceNeighbours& neighbours;
    const Geometry& geometry;
    const ScanOptions& options;
};

/// One pixel's answer; a view, valid until the next pixel. A pixel that shows one face only has that part,
/// with weight 1 and background 0; one that shows the background only has no part.
struct DividedView {
    Division division = Division::ExactAreas;
    std::span<const SeenPart> parts;  ///< each names a projected face
    double background = 0;
};

/// Divides a pixel among its candidates, in the way that the extraction rule asks for. One object a thread.
class PixelDivision {
  public:
    explicit PixelDivision(const ScanQuestion& question)
        : question_(question), visible_areas_(question.options.engine) {}

    DividedView operator()(PixelIndex pixel, std::span<const Candidate> candidates);

  private:
    DividedView by_exact_areas(PixelIndex pixel, std::span<const Candidate> candidates);
    DividedView by_visible_areas(PixelIndex pixel, std::span<const Candidate> candidates);
    DividedView by_scanline(PixelIndex pixel, std::span<const Candidate> candidates);
    /// Paper 2.1: an outline of a conductor, or a near-horizontal edge of anything else, meets the pixel.
    bool flagged(PixelIndex pixel, std::span<const Candidate> candidates) const;

    ScanQuestion question_;
    enum class Fate : std::uint8_t {
        Open,    ///< no search for layers has reached it
        Asked,   ///< it may be seen
        Hidden,  ///< it lies behind a layer
    };

    ClosedLayer layer_;
    std::vector<Fate> fate_;
    std::vector<std::uint32_t> nearest_first_;
    std::vector<std::uint32_t> kept_;  ///< candidates that are not hidden
    FacesApart apart_;
    VisibleAreas visible_areas_;
    ScanlineLengths scanline_lengths_;
    std::vector<FaceView> asked_;
    std::vector<std::uint32_t> asked_face_;  ///< their positions among the projected faces
    std::vector<SeenPart> parts_;
};

}  // namespace keikan
