// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "keikan/scan/projected_faces.hpp"
#include "visible_stretches.hpp"

namespace keikan::baseline {

/// Scanlines at equal distances: line k is y = (first + k + offset) / per_row.
struct Scanlines {
    std::int64_t first = 0;
    double offset = 0;
    int per_row = 1;
    int count = 0;
    double y(int k) const { return (static_cast<double>(first + k) + offset) / per_row; }
};

/// The scanline algorithm: lines from the top to the bottom, a list of the faces that the line crosses, kept
/// by rising x; each face with the two edges that the line crosses and their slopes, which change only where
/// a vertex is passed. A line crosses a face from its top on (inclusive) to its bottom (exclusive).
///
/// Property: (1) Two faces with a common edge are crossed at the same double there: no gap, no overlap.
/// Cost:     for each line linear in the faces that it crosses, but for the sorting of those that begin at
/// it.
class ScanlineSweep {
  public:
    explicit ScanlineSweep(const ProjectedFaces& faces) : faces_(faces) {}

    /// Calls `take(k, stretches)` for every line from the top, with what is seen along it over [0, width].
    void operator()(std::span<const std::uint32_t> faces, const Scanlines& lines, double width,
                    const std::function<void(int line, std::span<const Stretch>)>& take);

  private:
    /// A way from a face's top corner to its bottom corner: one of its two sides.
    struct Side {
        double x = 0, y = 0;  ///< upper end of the edge that the line crosses
        double slope = 0;
        double bottom = 0;         ///< of that edge
        std::uint32_t corner = 0;  ///< where the edge ends
        double at(double line) const { return x + (line - y) * slope; }
    };
    struct Active {
        Side one, other;
        double bottom = 0;
        std::uint32_t face = 0;
        Crossed crossed;
    };
    struct Place {
        double begin = 0;
        std::uint32_t active = 0;
    };

    void sort_by_first_line(std::span<const std::uint32_t> faces, const Scanlines& lines);
    void go_down(Side& side, std::span<const Point> outline, bool forwards, double line) const;
    std::uint32_t activate(std::uint32_t face, double line);
    void cross(Active& active, double line) const;
    void keep_what_is_crossed(double line);
    void add_what_begins(std::span<const std::uint32_t> faces, double line);

    const ProjectedFaces& faces_;
    std::vector<std::uint32_t> first_line_begin_;  ///< lines + 1 values, into by_first_line_
    std::vector<std::uint32_t> by_first_line_;
    std::vector<std::uint32_t> first_line_;
    std::vector<Active> active_;
    std::vector<std::uint32_t> free_;
    std::vector<Place> order_, fresh_, merged_;
    std::vector<Crossed> crossed_;
    VisibleStretches visible_;
};

}  // namespace keikan::baseline
