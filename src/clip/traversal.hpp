// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "keikan/clip/ring_difference.hpp"
#include "keikan/model/clip_step.hpp"
#include "keikan/model/face.hpp"
#include "partition.hpp"

namespace keikan::clip {

/// Section 3.2 of the paper, mended: each face, as a sum of signed rings, is clipped by every face that is
/// nearer, always by the original outline (clipped to the pixel), or by its nearer part where the two pass
/// through each other. What remains is the visible outline itself, without seams.
class Traversal {
  public:
    using Observer = std::function<void(const ClipStep&)>;

    /// What of the face entrants.faces[who] can be seen. Valid until the next call.
    const SignedRings& visible(PixelIndex pixel, const Entrants& entrants, std::uint32_t who,
                               Nearness nearness, const Observer& observer);
    /// What no face covers.
    const SignedRings& background(const Entrants& entrants, const Observer& observer);

    /// Clip steps in which rounding had folded a ring (RingDifference::folds).
    std::uint64_t folds() const { return difference_.folds(); }

  private:
    bool hides(PixelIndex pixel, const Entrants& entrants, std::uint32_t front, std::uint32_t behind,
               Nearness nearness);
    void subtract(std::span<const Point> clipper, const Box& box, const Observer& observer);

    RingDifference difference_{IntersectionClassifier::Lattice::Pixel};
    SignedRings remaining_;
    SignedRings next_;
    std::vector<Point> clipper_;  ///< the original outline, or its nearer part
    std::vector<double> side_;
    std::vector<Point> outside_;  ///< what the cut by nearness leaves over
};

}  // namespace keikan::clip
