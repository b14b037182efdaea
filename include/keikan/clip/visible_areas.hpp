// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "keikan/model/clip_step.hpp"
#include "keikan/model/coverage.hpp"
#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"

namespace keikan {

/// How far an area may be from the exact one, as a fraction of the pixel, with at most 8 faces in it
/// (docs/numerics.md derives it).
inline constexpr double kVisibleAreaError = 2e-15;
/// The same for the sum of all areas and the background, which is 1, with at most 32 faces.
inline constexpr double kAreaSumError = 4e-15;

/// How the pixel is divided (docs/numerics.md says what each is for, with figures).
enum class Engine {
    Splitting,  ///< convex cells in remainder form: fastest, the renderer's
    Traversal,  ///< the paper's clipper, mended: visible outlines and classified contacts too
    Published,  ///< the paper's clipper to the letter: to be studied; its areas may be wrong
};

/// What went on inside, since the object was made.
struct ClipStatistics {
    std::uint64_t folds = 0;              ///< Traversal: RingDifference::folds
    std::uint64_t did_not_close = 0;      ///< Published: PublishedTroubles
    std::uint64_t odd_intersections = 0;  ///< Published
};

/// Divides one pixel among the faces seen in it. One object a thread: it owns the memory that the work
/// needs, so that no pixel allocates once the object has seen a pixel of that size.
///
/// Properties:
///   (1) Every area is positive and at most 1, and so is what stays of the background, or it is 0.
///   (2) The areas and the background add up to 1 within kAreaSumError.
///   (3) With Nearness::ByDepth the result is the same, bit for bit, for every order of `faces`.
///   (4) The result is the same for either orientation of an outline and for every start vertex.
///   (5) The same faces moved by whole pixels, where that is exact, give the same bits.
///   (6) Faces may pass through each other and overlap in a cycle.
///   (7) A face that alone is seen in the pixel, and all over it, has area 1 and centroid (1/2, 1/2),
///   exactly.
///   (8) Mirrored faces, where mirroring is exact, show the same areas, each within its error.
///   (9) A face asked about again, behind itself, shows nothing and hides nothing more, within the error.
/// Engine::Published promises none of them; under Nearness::ByDepth it lists the faces by w in their middle.
///
/// Requires: convex outlines (repeated points and outlines without area are allowed), finite numbers.
///           An outline that rounding made concave is taken as its convex hull.
/// Error:    kVisibleAreaError up to 8 faces, whatever their extent (1e6 pixels) and wherever the pixel.
/// Paper:    section 3.1, steps (2) to (6). Departure: pairwise nearness instead of a sorted list.
/// Checked:  every pixel of every picture, by verify/crosscheck.
class VisibleAreas {
  public:
    explicit VisibleAreas(Engine engine = Engine::Splitting);
    ~VisibleAreas();
    VisibleAreas(VisibleAreas&&) noexcept;
    VisibleAreas& operator=(VisibleAreas&&) noexcept;

    /// The answer for one pixel; valid until the next call.
    PixelCoverage operator()(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

    /// The visible regions of the last call as convex pieces without overlap, the background among them.
    /// Engine::Splitting only; nothing of the others.
    std::span<const VisiblePiece> pieces();

    /// The visible regions of the last call as sums of signed rings without seams, the background among them.
    /// Engine::Traversal, and Engine::Published as far as it goes: its pieces, without the areas that Fig. 3
    /// only remembers to subtract. Nothing of Engine::Splitting.
    std::span<const VisibleOutline> outlines();

    /// Engine::Traversal and Engine::Published: every clip step of the calls to come is shown to `observer`,
    /// in order. Published's contacts have no turns: they are numbered, odd ones enter (Turn::Touch stands
    /// there).
    void observe(std::function<void(const ClipStep&)> observer);

    ClipStatistics statistics() const;

  private:
    struct Working;
    std::unique_ptr<Working> working_;
};

}  // namespace keikan
