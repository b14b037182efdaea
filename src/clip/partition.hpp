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
    std::uint32_t ring = 0;  ///< where its corners start among `corners` of Entrants
    std::uint32_t size = 0;  ///< how many there are
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
    void begin(PixelIndex pixel, const Entrants& entrants, Nearness nearness);

    /// Inserts the face entrants.faces[who]. With Nearness::ByDepth the faces come by falling w_max.
    void insert(std::uint32_t who);

    /// Nothing is free, and no face with w up to `w` can be seen any more.
    bool hides_all_below(double w) const;

    std::size_t size() const { return size_; }
    std::uint32_t label(std::size_t cell) const { return label_[cell]; }
    std::span<const Point> ring(std::size_t cell) const {
        return {points_.data() + ring_[cell].begin, ring_[cell].size};
    }

  private:
    /// Of the face being inserted to another, where both are. Open: the rough difference could not tell.
    enum class Relation : std::uint8_t { Unknown, Open, Behind, InFront, Mixed };
    struct Range {
        std::uint32_t begin = 0;
        std::uint32_t size = 0;
    };
    /// A ring on its way through the cuts: first a cell's, then in one or the other buffer.
    struct Current {
        const Point* ring;
        std::size_t size;
        Point* free_buffer;
        Point* other_buffer;
    };

    void cuts_of(const Entrant& face);
    void find_cells_near(const Box& box);
    Relation rough_relation_to(std::uint32_t label);
    Relation relation_to(std::uint32_t label);
    bool find_reaching_cuts(std::uint32_t cell);
    void carve(std::uint32_t cell);
    /// Divides `current`; the outside part becomes pending. False if nothing of it is inside.
    template <class Cut>
    bool keep_inside(Current& current, const Cut& cut);
    void set_cell(std::size_t cell, Range ring, std::uint32_t label);
    void append_cell(Range ring, std::uint32_t label);
    /// No later face can change the cell.
    void settle(std::size_t cell);
    void reserve_points(std::size_t more);
    void reserve_cells(std::size_t more);

    PixelIndex pixel_;
    const Entrants* entrants_ = nullptr;
    Nearness nearness_ = Nearness::InOrder;

    // The cells: parallel arrays. Boxes are in steps of 1 / kBoxSteps, rounded outwards.
    std::size_t size_ = 0;
    std::vector<Range> ring_;
    std::vector<std::uint32_t> label_;
    std::vector<std::int16_t> min_x_, min_y_, max_x_, max_y_;
    std::vector<std::uint32_t> cells_of_;  ///< how many cells each face owns
    std::size_t free_cells_ = 0;
    std::vector<Point> points_;  ///< the corners of all cells, and those of cells that have been divided
    std::size_t used_ = 0;

    // The face being inserted.
    std::uint32_t who_ = 0;
    std::vector<EdgeCut> cuts_;                   ///< its edges inside the pixel
    std::vector<std::uint32_t> reaching_;         ///< those that cut the cell at hand
    std::vector<std::int16_t> hit_;               ///< for each cell, whether its box meets the face's
    std::vector<std::uint32_t> near_;             ///< the cells that do
    std::vector<Relation> relation_;              ///< to each other face
    std::vector<NearnessDifference> difference_;  ///< from each other face, where Mixed
    std::vector<Range> pending_;                  ///< parts of the cell at hand that stay outside
    std::vector<Point> buffer_;
    std::vector<double> side_;
};

}  // namespace keikan::clip
