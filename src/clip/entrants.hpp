// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "convex_outline.hpp"
#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"
#include "nearer_part.hpp"

namespace keikan::clip {

/// A face that has area in the pixel.
struct Entrant {
    std::uint32_t position = 0;  ///< in the list of faces asked about
    FaceId id = 0;
    std::uint32_t ring = 0;  ///< where its corners start among `corners` of Entrants
    std::uint32_t size = 0;  ///< how many there are
    Box box;
    bool alone = false;           ///< overlaps no other (find_lone_faces)
    LocalPlane plane;             ///< from measure_depths, as is what follows
    double w_min = 0, w_max = 0;  ///< at the corners of the ring
    double w_error = 0;           ///< of either
};

/// The faces of one pixel, clipped to it, with their corners in one pool.
struct Entrants {
    std::vector<Entrant> faces;
    std::vector<Point> corners;

    void clear() { faces.clear(), corners.clear(); }
    std::span<const Point> ring(const Entrant& e) const { return {corners.data() + e.ring, e.size}; }
};

/// Reads the faces of a pixel. It owns the memory for that.
class EntrantReader {
  public:
    /// The faces that have area in the pixel, in the order of `faces`, but for those that a single other face
    /// hides as a whole, by covering all of the pixel in front of them.
    void read(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness, Entrants& entrants);

  private:
    /// An interval that certainly holds w over the whole pixel.
    struct DepthRange {
        double min = 0, max = 0;
    };
    /// A face before it is clipped.
    struct Candidate {
        std::uint32_t position = 0;
        Overlap overlap = Overlap::Nothing;
        std::size_t views = 0;  ///< where the views of its edges start
        ConvexOutline outline;
        DepthRange depth;
    };

    static DepthRange depth_range(PixelIndex pixel, const DepthPlane& plane);
    ConvexOutline convex(std::span<const Point> outline);
    void find_candidates(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness);

    std::vector<Candidate> candidates_;
    std::vector<EdgeView> views_;
    std::vector<std::vector<Point>> hulls_;  ///< of outlines that are not strictly convex as given
    std::size_t hulls_used_ = 0;
    std::vector<Point> scratch_;
};

/// Finds the faces that overlap no other: for each other there is an edge of one of the two that leaves the
/// other on its outer side, or within one step of the 2^-53 grid of it. Such a face shows all of itself, and
/// neither depth nor cells are needed for it: the common case on one surface. Among more faces than
/// kMostCompared hardly any is alone, and none is looked for.
inline constexpr std::size_t kMostCompared = 8;
void find_lone_faces(Entrants& entrants);

/// The depth planes relative to the pixel, of the faces that are not alone.
void measure_depths(PixelIndex pixel, std::span<const FaceView> faces, Entrants& entrants);

/// Sorts by falling w_max and, where that is equal, by what else the faces are: never by their places in the
/// list. Those that are alone come last.
void put_in_order_of_depth(Entrants& entrants);

/// Keeps the order of the list, but those that are alone come last.
void put_in_order_of_list(Entrants& entrants);

}  // namespace keikan::clip
