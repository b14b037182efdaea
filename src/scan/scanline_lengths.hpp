// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"
#include "keikan/scan/scan_band.hpp"

namespace keikan {

/// How much of the scanline through a pixel's centre, y = pixel.y + 1/2, each face shows: the paper's weights
/// of a pixel that is not flagged (2.1). One object a thread.
///
/// Properties:
///   (1) Weights are positive, and with `background` add up to 1 within rounding.
///   (2) Where faces overlap the larger w is seen, split at the point where two planes meet; where they are
///       equal all along, the smaller id.
/// Error: a crossing is rounded like any quotient; no sign hangs on it. 1e-15 x the outline's extent [px].
class ScanlineLengths {
  public:
    /// `faces` by rising id. A part's face is the position in `faces`; its centroid lies on the scanline.
    std::span<const SeenPart> operator()(PixelIndex pixel, std::span<const FaceView> faces);
    double background() const { return background_; }

  private:
    /// A stretch of the scanline, pixel-local, and the face seen on it; nearness w = slope x + start there.
    struct Stretch {
        double begin = 0, end = 0;
        double slope = 0, start = 0;
        std::uint32_t face = 0;
    };
    void put(const Stretch& face);

    std::vector<Stretch> seen_;  ///< disjoint, by rising x
    std::vector<Stretch> next_;
    std::vector<SeenPart> parts_;
    double background_ = 1;
};

}  // namespace keikan
