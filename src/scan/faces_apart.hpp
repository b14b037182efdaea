// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/scan/scan_band.hpp"
#include "tile_candidates.hpp"

namespace keikan {

/// The commonest divided pixel beside those of a terrain: a few faces that do not overlap, such as the sides
/// of a wire, before the background or before one face that covers the pixel. Each of them shows all of
/// itself, the cover or the background the rest. One object a thread.
class FacesApart {
  public:
    /// Divides the pixel among `candidates[kept[0]]`, `candidates[kept[1]]`, ..., which are all that may be
    /// seen in it; by rising face. False when they are not of that kind, or there are too many to be worth
    /// it.
    ///
    /// That two faces do not overlap is certain: they are the neighbours of a common edge, or their boxes, or
    /// all corners of one and an edge of the other, are apart by exact signs. So is that the cover lies
    /// behind.
    bool divide(PixelIndex pixel, const ProjectedFaces& faces, const std::vector<FaceFacts>& facts,
                const FaceNeighbours& neighbours, std::span<const Candidate> candidates,
                std::span<const std::uint32_t> kept);

    std::span<const SeenPart> parts() const { return parts_; }  ///< by rising (projected) face
    double background() const { return background_; }

  private:
    std::vector<SeenPart> parts_;
    double background_ = 0;
};

}  // namespace keikan
