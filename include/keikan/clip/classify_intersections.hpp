// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/model/contact.hpp"
#include "keikan/model/point.hpp"

namespace keikan {

/// Finds where the boundary of a ring meets the boundary of a convex clipper, and what happens there. One
/// object a thread: it owns the memory, and allocates only when a ring is larger than any before.
///
/// One rule decides every turn (departure D1): at the point, each of the subject's two directions either
/// points strictly outside the closed wedge (at a vertex) or edge of the clipper, or does not.
///
/// Properties:
///   (1) Contacts come in the order of travel along `subject`, from its vertex 0.
///   (2) Enters and Leaves alternate (Touches aside), so there are as many of each.
///   (3) Reversing `subject` swaps Enters and Leaves. Starting either ring elsewhere changes only indices.
///   (4) A run of boundary that both share has contacts at the vertices on it, and nowhere else.
///   (5) An edge of `subject` has at most two contacts inside it; if two, the first enters and the second
///   leaves.
///
/// Requires: `subject`: at least three points, consecutive ones differ; it may be concave, touch itself and
///           (where rounding made it so) cross itself. `clip`: exactly strictly convex, turning from +x
///           towards +y. Finite coordinates.
/// Exact:    everything but the point of EdgeEdge: every choice is the sign of an orient2d of given points.
/// Error:    an EdgeEdge point is within kCrossingError times the extent of the subject's edge of both edges'
/// lines
///           (along nearly parallel edges it may be further from the exact crossing).
/// Cost:     subject.size() * clip.size() orientations.
/// Paper:    section 3.2.1, Fig. 4 (a) to (e). Departure D1: case (4) follows the rule of (1) to (3).
/// Checked:  every contact of every clip step, by verify/oracle/exact_intersections.
class IntersectionClassifier {
  public:
    /// Where EdgeEdge points are rounded to.
    enum class Lattice {
        Doubles,  ///< the nearest doubles
        Pixel,    ///< multiples of 2^-53: for pixel-local coordinates, on which orient2d is cheapest
    };
    explicit IntersectionClassifier(Lattice lattice = Lattice::Doubles) : lattice_(lattice) {}

    std::span<const Contact> operator()(std::span<const Point> subject, std::span<const Point> clip);

    /// Of the last call: how often `subject` winds around a point just outside edge 0 of `clip`, next to
    /// its end. Exact. It settles how many whole copies of the clipper a difference must hold.
    int winding_outside_first_edge() const { return winding_; }

    /// Of the last call: whether any vertex of `subject` lies strictly outside the closed clipper.
    bool reaches_outside() const { return reaches_outside_; }

  private:
    enum class Place : std::uint8_t { Outside, Inside, OnEdge, OnVertex };
    struct Location {
        Place place = Place::Inside;
        std::uint32_t clip = 0;  ///< the edge or vertex that it is on
    };

    std::int8_t side(std::size_t vertex, std::size_t edge) const {
        return sides_[vertex * clip_.size() + edge];
    }
    bool outside_wedge(std::size_t vertex, std::size_t clip_vertex) const;
    void measure_sides();
    Location locate(std::size_t vertex) const;
    void contact_at_vertex(std::size_t vertex);
    void contacts_inside_edge(std::size_t vertex);
    void contacts_along_edge(std::size_t vertex, std::size_t edge);
    void contacts_across(std::size_t vertex);
    Point crossing(std::size_t vertex, std::size_t edge) const;
    void count_winding();
    std::size_t after(std::size_t vertex) const { return vertex + 1 == subject_.size() ? 0 : vertex + 1; }
    std::size_t before(std::size_t vertex) const { return (vertex == 0 ? subject_.size() : vertex) - 1; }
    std::size_t clip_after(std::size_t vertex) const { return vertex + 1 == clip_.size() ? 0 : vertex + 1; }
    std::size_t clip_before(std::size_t vertex) const { return (vertex == 0 ? clip_.size() : vertex) - 1; }

    Lattice lattice_;
    std::span<const Point> subject_;
    std::span<const Point> clip_;
    std::vector<std::int8_t> sides_;  ///< of subject vertex i and clip edge j, at i * clip.size() + j
    std::vector<Location> locations_;
    std::vector<Contact> contacts_;
    int winding_ = 0;
    bool reaches_outside_ = false;
};

/// Error of a crossing point per unit of the subject edge's extent: half a unit in the last place each for
/// the two side values, their difference, the quotient, the product and the sum (docs/numerics.md).
inline constexpr double kCrossingError = 4.5e-16;

}  // namespace keikan
