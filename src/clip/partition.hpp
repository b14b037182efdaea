// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/face.hpp"
#include "nearer_part.hpp"
#include "split.hpp"

namespace keikan::clip {

/// A face that has area in the pixel.
struct Entrant {
    std::uint32_t position = 0;  ///< in the list of faces asked about
    FaceId id = 0;
    std::size_t ring = 0;  ///< where its corners start among `corners` of Entrants
    std::size_t size = 0;  ///< how many there are
    Box box;
    LocalPlane plane;             ///< of Nearness::ByDepth only, as is what follows
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

/// The pixel as convex cells without overlap, each labelled with the face that is nearest there among those
/// inserted so far, or free. Inserting a face cuts it out of the free cells, and out of the cells of those
/// faces in front of which it lies, there along the line where the two planes meet as well. No order of
/// depth is assumed: cyclic overlap and faces through each other need nothing more.
class Partition {
  public:
    static constexpr std::uint32_t kFree = 0xFFFFFFFFu;

    /// One free cell: the pixel.
    void begin(PixelIndex pixel, const Entrants& entrants);

    /// Inserts the face entrants.faces[who].
    void insert(std::uint32_t who, Nearness nearness);

    std::size_t free_cells() const { return free_cells_; }
    std::size_t size() const { return label_.size(); }
    std::uint32_t label(std::size_t cell) const { return label_[cell]; }
    std::span<const Point> ring(std::size_t cell) const {
        return {points_.data() + ring_[cell].begin, ring_[cell].size};
    }

  private:
    enum class Relation : std::uint8_t { Unknown, Behind, InFront, Mixed };
    struct Range {
        std::size_t begin = 0;
        std::size_t size = 0;
    };

    void cuts_of(const Entrant& face);
    void find_cells_near(const Box& box);
    Relation relation_to(std::uint32_t label);
    bool find_reaching_cuts(Range ring);
    void carve(std::size_t cell, Relation relation);
    /// Divides `current`; the outside part becomes pending. False if nothing of it is inside.
    template <class Side, class Weld>
    bool keep_inside(Range& current, double on_line, Side side, Weld weld);
    void set_cell(std::size_t cell, Range ring, std::uint32_t label);
    void append_cell(Range ring, std::uint32_t label);
    void reserve_points(std::size_t more);

    PixelIndex pixel_;
    const Entrants* entrants_ = nullptr;

    // The cells: parallel arrays. The boxes are rounded to float.
    std::vector<Range> ring_;
    std::vector<std::uint32_t> label_;
    std::vector<float> min_x_, min_y_, max_x_, max_y_;
    std::size_t free_cells_ = 0;
    std::vector<Point> points_;  ///< the corners of all cells, and what the cutting leaves behind
    std::size_t used_ = 0;

    // The face being inserted.
    std::uint32_t who_ = 0;
    std::vector<EdgeCut> cuts_;                   ///< its edges inside the pixel
    std::vector<std::uint32_t> reaching_;         ///< those that cut the cell at hand
    std::vector<std::uint32_t> near_;             ///< cells whose box meets its box
    std::vector<Relation> relation_;              ///< to each other face
    std::vector<NearnessDifference> difference_;  ///< from each other face, where Mixed
    std::vector<Range> pending_;                  ///< parts of the cell at hand that stay outside
    std::vector<double> side_;
};

}  // namespace keikan::clip
