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
///   (6) Moving or mirroring both rings, where that is exact, changes neither classes nor turns. (A mirrored
///   clipper is listed backwards, so that it turns as it must.)
///
/// Requires: `subject`: at least three points, consecutive ones differ; it may be concave, touch itself and
///           (where rounding made it so) cross itself. `clip`: exactly strictly convex, turning from +x
///           towards +y. Finite coordinates.
/// Exact:    everything but the point of EdgeEdge: every choice is the sign of an orient2d of given points.
/// Error:    an EdgeEdge point is within kCrossingError times the extent of the subject's edge of both lines
///           (along nearly parallel edges it may be further from the exact crossing).
/// Cost:     subject.size() * clip.size() orientations.
/// Paper:    section 3.2.1, Fig. 4 (a) to (e). Departure D1: case (4) follows the rule of (1) to (3).
/// Checked:  every contact of every clip step, by verify/oracle/exact_intersections.
class IntersectionClassifier {
  public:
    /// Where EdgeEdge points are rounded to.
    enum class Lattice {
        Doubles,  ///< the nearest doubles
        Pixel,    ///< multiples of 2^-53; both rings must hold nothing else, all of it in [0, 1]
    };
    explicit IntersectionClassifier(Lattice lattice = Lattice::Doubles) : lattice_(lattice) {}

    std::span<const Contact> operator()(std::span<const Point> subject, std::span<const Point> clip);

    /// How two rings lie as a whole.
    enum class Position {
        Apart,   ///< an edge of the clipper has the subject on its outer side or its line: nothing in common
        Within,  ///< no vertex of the subject is strictly outside the closed clipper: nor is anything else
        Open,    ///< neither
    };
    /// The first half of the work: it goes no further than the answer needs.
    Position position(std::span<const Point> subject, std::span<const Point> clip);
    /// The second half: the contacts of the rings of the last `position`. Requires: it was Open.
    std::span<const Contact> contacts();

    /// After `contacts`, how often `subject` winds around a point just outside edge 0 of `clip`, next to its
    /// end. Exact. It settles how many whole copies of the clipper a difference must hold. The rings must
    /// still be there.
    int winding_outside_first_edge() const;

  private:
    using Set = std::uint64_t;  ///< of vertices of the subject, or of the edges that start there, by bits
    enum class Place : std::uint8_t { Outside, Inside, OnEdge, OnVertex };
    struct Location {
        Place place = Place::Inside;
        std::uint32_t clip = 0;  ///< the edge or vertex that it is on
    };

    template <class Line>
    Position measure_sides(bool all);
    template <class Line>
    Position measure_many_sides();
    template <class Line>
    void contacts_across(std::size_t vertex);
    template <class Line>
    int count_winding() const;
    int side(std::size_t vertex, std::size_t edge) const {
        const std::size_t word = edge * words_ + vertex / 64;
        return (outside_[word] >> vertex % 64 & 1) != 0 ? -1 : (on_[word] >> vertex % 64 & 1) != 0 ? 0 : 1;
    }
    bool outside_wedge(std::size_t vertex, std::size_t clip_vertex) const;
    Location locate(std::size_t vertex) const;
    void find_contacts_by_sets();
    void find_contacts_one_by_one();
    void contact_at_vertex(std::size_t vertex, Location here);
    void contacts_inside_edge(std::size_t vertex);
    void contacts_along_edge(std::size_t vertex, std::size_t edge);
    void contacts_across(std::size_t vertex);
    void contact_crossing(std::size_t vertex, std::size_t edge);
    Point crossing(std::size_t vertex, std::size_t edge) const;
    std::size_t after(std::size_t vertex) const { return vertex + 1 == subject_.size() ? 0 : vertex + 1; }
    std::size_t before(std::size_t vertex) const { return (vertex == 0 ? subject_.size() : vertex) - 1; }
    std::size_t clip_after(std::size_t vertex) const { return vertex + 1 == clip_.size() ? 0 : vertex + 1; }
    std::size_t clip_before(std::size_t vertex) const { return (vertex == 0 ? clip_.size() : vertex) - 1; }

    Lattice lattice_;
    std::span<const Point> subject_;
    std::span<const Point> clip_;
    // For each edge of the clipper, words_ sets: the subject's vertices strictly outside it and on its line.
    std::size_t words_ = 1;
    std::vector<Set> outside_;
    std::vector<Set> on_;
    std::vector<Contact> contacts_;
};

/// Error of a crossing point per unit of the subject edge's extent: half a unit in the last place each for
/// the two side values, their difference, the quotient, the product and the sum (docs/numerics.md).
inline constexpr double kCrossingError = 4.5e-16;

}  // namespace keikan
