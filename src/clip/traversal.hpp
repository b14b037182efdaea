// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "entrants.hpp"
#include "keikan/clip/ring_difference.hpp"
#include "keikan/model/clip_step.hpp"
#include "keikan/model/coverage.hpp"
#include "keikan/model/face.hpp"
#include "measure.hpp"

namespace keikan::clip {

/// Section 3.2 of the paper, mended: each face, as a sum of signed rings, is clipped by every face that is
/// nearer, always by the original outline (clipped to the pixel), or by its nearer part where the two pass
/// through each other. What remains is the visible outline itself, without seams.
class Traversal {
  public:
    using Observer = std::function<void(const ClipStep&)>;

    /// Measures what can be seen of each of entrants.faces; returns the area that no face covers: what the
    /// areas leave of 1, or 0 if that may be rounding.
    double measure(PixelIndex pixel, const Entrants& entrants, Nearness nearness, const Observer& observer,
                   std::vector<Measure>& measures);

    /// The visible outlines of the last `measure`, and the background's, which is found when it is first
    /// asked for (or right away where an observer waits for its clip steps).
    std::span<const VisibleOutline> outlines(const Entrants& entrants, const Observer& observer);

    /// Clip steps in which rounding had folded a ring (RingDifference::folds).
    std::uint64_t folds() const { return difference_.folds(); }

  private:
    void find_visible(PixelIndex pixel, const Entrants& entrants, std::uint32_t who, Nearness nearness,
                      const Observer& observer);
    void find_background(const Entrants& entrants, const Observer& observer);
    void keep_remaining(std::uint32_t face);
    std::span<const Point> hiding_part(PixelIndex pixel, const Entrants& entrants, const Entrant& front,
                                       const Entrant& behind);
    void subtract(std::span<const Point> clipper, const Entrant& front, std::uint32_t behind,
                  const Observer& observer);

    RingDifference difference_{IntersectionClassifier::Lattice::Pixel};
    SignedRings remaining_;
    SignedRings next_;
    SignedRings found_;                   ///< the visible outlines
    std::vector<std::uint32_t> face_of_;  ///< whose they are: positions in the list of faces
    bool background_found_ = false;
    std::vector<VisibleOutline> outlines_;
    std::vector<Point> nearer_part_;
    std::vector<Point> farther_part_;
    std::vector<double> side_;
};

}  // namespace keikan::clip
