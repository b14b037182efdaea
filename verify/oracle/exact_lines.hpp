// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gmpxx.h>

#include <cstdint>
#include <deque>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"
#include "key_table.hpp"
#include "wide_integer.hpp"

namespace keikan::oracle {

using LineId = std::int32_t;
using VertexId = std::int32_t;

/// A line and which side of it is meant.
struct SidedLine {
    LineId line = 0;
    int sense = 1;  ///< 1: the line's own positive side; -1: the other
};

/// The lines of one pixel, and the points where two of them meet, known exactly.
///
/// A line is the question's: a border of the pixel, the line through two corners of an outline, or the line
/// on which two depth planes are equal. The line of an edge that two faces share is one line, whichever way
/// either runs along it. A vertex is two lines. Whether it lies left of, on or right of a third is the sign
/// of a determinant of nine given numbers, whatever was cut before.
///
/// Coordinates are pixel-local, in units of 2^-kUnitBits pixels.
class ExactLines {
  public:
    /// `Vertex::fixed_x` counts 2^-kFixedBits pixels.
    static constexpr int kFixedBits = 62;
    /// Pixels by which either fixed coordinate may be off (derivation in exact_lines.cpp).
    static constexpr double kVertexError = 0x1p-61;

    struct Vertex {
        double x, y;           ///< within 2^-53 of the exact ones, pixel-local
        std::int64_t fixed_x;  ///< in units of 2^-kFixedBits, within kVertexError
        std::int64_t fixed_y;
        LineId first, second;
        std::int32_t corner;      ///< the outlines' corner that both lines pass through, or -1
        std::int32_t any_length;  ///< where its exact coordinates stand if they do not fit, or -1
    };

    /// Forgets everything; the four borders of `pixel` become lines 0..3, its corners vertices 0..3, where
    /// line i leads from vertex i to vertex i + 1, counter-clockwise (with y upwards).
    void start(PixelIndex pixel);

    /// The line through two corners of an outline; its positive side is to the left of p q.
    /// Requires: p != q.
    SidedLine line_through(Point p, Point q);

    /// Where `nearer` has the larger w. The planes must differ in a or b.
    SidedLine line_of_equal_depth(const DepthPlane& nearer, const DepthPlane& farther);

    /// -1, 0, 1: right of, on, left of the line. Exact. Requires: the vertex is in the pixel.
    int side(VertexId vertex, LineId line) {
        const Vertex& v = vertices_[static_cast<std::size_t>(vertex)];
        const Line& l = lines_[static_cast<std::size_t>(line)];
        if (v.first == line || v.second == line) return 0;
        if (v.corner >= 0 && (v.corner == l.from || v.corner == l.to)) return 0;
        const double value = l.a * v.x + l.b * v.y + l.c;
        if (value > l.uncertain) return 1;
        if (value < -l.uncertain) return -1;
        return exact_side(vertex, line);
    }
    int side(VertexId vertex, SidedLine line) { return line.sense * side(vertex, line.line); }

    /// Requires: the lines cross at one point of the pixel.
    VertexId meeting_point(LineId first, LineId second);

    const Vertex& vertex(VertexId id) const { return vertices_[static_cast<std::size_t>(id)]; }

    /// For taking back what was tried: vertices from `count` on are forgotten.
    std::size_t vertex_count() const { return vertices_.size(); }
    void forget_vertices_from(std::size_t count);

  private:
    /// a x + b y + c, twice: rounded, and exact where it fits.
    struct Line {
        double a, b, c;           ///< each within 2^-52 of its size, up to a common factor
        double uncertain;         ///< values of this size or less say nothing about the sign
        std::int32_t from, to;    ///< the outlines' corners that it leads through, or -1
        bool fits;                ///< its `exact_lines_` entry holds it
        std::int32_t any_length;  ///< its place in `long_lines_`, or -1 if it has not been needed there
    };
    struct ExactLine {
        WideInteger<2> a, b;
        WideInteger<4> c;
    };
    struct ExactVertex {  ///< (x/w, y/w), w > 0
        WideInteger<6> x, y;
        WideInteger<4> w;
    };
    struct AnyLength {
        mpz_class x, y, w;                   ///< of a line: a, b, c
        long double near_x, near_y, near_w;  ///< within 2^-52 of their size, unless too large for the type

        void round();
    };

    int exact_side(VertexId vertex, LineId line);
    int side_of_any_length(VertexId vertex, LineId line);
    void add_borders();
    LineId add_line(const ExactLine& line, std::int32_t from, std::int32_t to);
    LineId add_line(AnyLength&& line, std::int32_t from, std::int32_t to);
    std::int32_t corner(Point p);
    const AnyLength& any_length_line(LineId line);
    VertexId meeting_point_of_any_length(Vertex vertex);

    PixelIndex pixel_;
    std::vector<Line> lines_;
    std::vector<ExactLine> exact_lines_;
    std::deque<AnyLength> long_lines_;  ///< their addresses last
    std::vector<Vertex> vertices_;
    std::vector<ExactVertex> exact_vertices_;
    std::vector<AnyLength> long_vertices_;
    KeyTable corners_;
    KeyTable edges_;
    AnyLength point_{}, sum_{};  ///< kept, so that their memory is
};

}  // namespace keikan::oracle
