// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/clip/ring_difference.hpp"
#include "keikan/model/clip_step.hpp"
#include "keikan/model/coverage.hpp"

namespace keikan::crosscheck {

/// What can be met while a pixel is clipped, each a bit of PixelKinds.
enum class PixelKind : std::uint8_t {
    EdgeEdge,  ///< a contact of class (1) of the paper, and so on
    SubjectVertex,
    ClipVertex,
    SharedVertex,
    Hole,              ///< a visible region has a ring of sign -1
    TouchingInside,    ///< an outline touches another's from inside, without passing through it there
    CyclicDepth,       ///< three faces or more hide parts of each other in a cycle
    Interpenetration,  ///< two faces hide parts of each other
};
inline constexpr int kPixelKinds = 8;
using PixelKinds = std::uint8_t;

constexpr PixelKinds bit_of(PixelKind kind) {
    return static_cast<PixelKinds>(1u << static_cast<unsigned>(kind));
}

/// "edge-edge", "hole" ... as pages and summaries call it.
const char* name_of(PixelKind kind);

/// Finds the kinds of one pixel after the other from the clip steps of Engine::Traversal. One object a
/// thread.
///
/// CyclicDepth and Interpenetration say what happened in this pixel: a face counts as hiding a part of
/// another where clipping by it takes away more than kVisibleAreaError, so that an edge that two faces share,
/// and that rounding has laid the one over the other, does not count.
class KindsOfPixel {
  public:
    /// Forgets the pixel before.
    void start();
    void take(const ClipStep& step);
    /// All kinds of the pixel, whose visible outlines these are.
    PixelKinds kinds(std::span<const VisibleOutline> outlines);

  private:
    struct Hiding {
        std::uint32_t front = 0, behind = 0;
    };
    bool takes_area(const ClipStep& step);
    bool in_cycle(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t>& visited) const;

    RingDifference difference_{IntersectionClassifier::Lattice::Pixel};
    SignedRings rest_;
    std::vector<Hiding> hidings_;
    PixelKinds found_ = 0;
};

}  // namespace keikan::crosscheck
