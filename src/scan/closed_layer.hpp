// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "edge_moments.hpp"
#include "keikan/scan/scan_band.hpp"
#include "tile_candidates.hpp"

namespace keikan {

/// Finds faces that tile a pixel side by side, as the faces of a terrain do, and their areas without any
/// clipping of faces against each other. One object a thread.
///
/// A set of faces of one turn is *closed* in a pixel when each of their edges either does not meet the
/// pixel's interior or is shared, the other way round and with the same doubles, with another face of the
/// set. Then the boundaries of all faces cancel inside the pixel, the number of faces over a point is the
/// same at almost all its points, and it equals the sum of the faces' areas in the pixel: a whole number.
/// If it is 1 the faces tile the pixel. No coordinate is compared with a tolerance; the sum need only be
/// told from the next whole number.
class ClosedLayer {
  public:
    /// A new pixel. False if no layer can tile it: at one of its corners, or at its middle, no candidate's
    /// bounding box is. Then there is nothing to look for.
    bool begin(PixelIndex pixel, const std::vector<FaceFacts>& facts, std::span<const Candidate> candidates);

    /// Looks for a closed set that holds `candidates[start]` and tiles the pixel. Faces that meet the pixel
    /// and are no candidates may be missing: a set that needs them is not closed.
    bool find(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
              const FaceNeighbours& neighbours, std::span<const Candidate> candidates, std::size_t start);

    /// Of the layer found, each face's share. Parts name projected faces and come by rising face. A share
    /// below what rounding can tell from nothing is left out.
    std::span<const SeenPart> parts() const { return parts_; }
    /// Whether candidate `other`, none of the layer found, lies wholly behind it within the pixel, for
    /// certain.
    bool hides(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
               std::span<const Candidate> candidates, std::size_t other) const;

    /// Candidates that the last search has reached, whether it found a layer or not.
    std::span<const std::uint32_t> reached() const { return members_; }
    bool has_reached(std::size_t candidate) const { return progress_[candidate].search == search_; }

  private:
    /// How far the search has come with a candidate.
    struct Progress {
        Moments moments;           ///< of the edges so far, in the direction of its outline
        std::uint32_t search = 0;  ///< the last one of the pixel that reached it, counted from 1
        std::uint8_t given = 0;    ///< bit e: edge e is in `moments`, from the neighbour's side
        bool is_done = false;
    };
    static_assert(FaceFacts::kMostEdges <= 8, "one bit of `given` for each edge");

    void add_member(std::size_t candidate);
    bool grow(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
              const FaceNeighbours& neighbours, std::span<const Candidate> candidates, std::size_t start);

    std::vector<std::uint32_t> members_;
    std::vector<Progress> progress_;
    std::uint32_t search_ = 0;
    std::vector<SeenPart> parts_;
    double w_min_ = 0;
};

}  // namespace keikan
