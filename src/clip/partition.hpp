// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "entrants.hpp"
#include "nearer_part.hpp"
#include "split.hpp"

namespace keikan::clip {

/// The pixel as convex cells without overlap, each labelled with the face that is nearest there among those
/// inserted so far, or free. Inserting a face cuts it out of the free cells, and out of the cells of those
/// faces in front of which it lies, there along the line where the two planes meet as well. No order of
/// depth is assumed: cyclic overlap and faces through each other need nothing more.
class Partition {
  public:
    static constexpr std::uint32_t kFree = 0xFFFFFFFFu;

    /// One free cell: the pixel.
    void begin(PixelIndex pixel, const Entrants& entrants);

    /// Inserts the face entrants.faces[who]. Nearness::ByDepth: the faces come by falling w_max.
    /// Nearness::InOrder: what an earlier face has it keeps.
    void insert(std::uint32_t who, Nearness nearness);

    /// Nothing is free, and no face with w up to `w` can be seen any more.
    bool hides_all_below(double w, Nearness nearness) const;

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
    /// A ring on its way through the cuts: first a cell's, then in one or the other of buffer_.
    struct Current {
        const Point* ring;
        std::size_t size;
        unsigned free_buffer = 0;
    };

    void cuts_of(const Entrant& face);
    void find_cells_near(const Box& box);
    Relation rough_relation_to(std::uint32_t label);
    Relation relation_to(std::uint32_t label);
    /// The same within one cell, where the planes cross somewhere.
    Relation relation_in(const Point* ring, std::size_t n, std::uint32_t label) const;
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
    Nearness nearness_ = Nearness::InOrder;
    std::vector<EdgeCut> cuts_;            ///< its edges inside the pixel
    std::vector<std::uint32_t> reaching_;  ///< those that cut the cell at hand
    std::size_t reaching_count_ = 0;
    std::vector<std::int16_t> hit_;    ///< for each cell, whether its box meets the face's
    std::vector<std::uint32_t> near_;  ///< the cells that do
    std::size_t near_count_ = 0;
    std::vector<Relation> relation_;              ///< to each other face
    std::vector<NearnessDifference> difference_;  ///< from each other face, where Mixed
    std::vector<Range> pending_;                  ///< parts of the cell at hand that stay outside
    std::vector<Point> buffer_[2];
    std::vector<double> side_;
};

}  // namespace keikan::clip
