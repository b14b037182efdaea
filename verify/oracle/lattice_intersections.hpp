// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "keikan/model/contact.hpp"
#include "keikan/model/point.hpp"
#include "wide_integer.hpp"

namespace keikan::oracle {

/// The answer of exact_intersections, in whole numbers of fixed length: some hundred times as fast, for
/// points that are whole multiples, below 2^60, of one power of two. Points of a pixel (multiples of 2^-53)
/// are.
///
/// The route is that of exact_intersections: each edge of the subject is divided at the points found on it,
/// which stand as fractions along the edge, and the exact middle of each part is located in the closed
/// clipper. Doubles only choose where their error cannot matter. One object a thread.
class LatticeIntersections {
  public:
    /// Nothing where the points do not fit; ask exact_intersections then. `Contact::point` of an EdgeEdge is
    /// within 2^-50 of its edge's extent. Valid until the next call. Requires: as exact_intersections.
    std::optional<std::span<const Contact>> operator()(std::span<const Point> subject,
                                                       std::span<const Point> clip);

  private:
    struct LatticePoint {
        std::int64_t x = 0, y = 0;
        friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
    };
    /// A place along an edge, at numerator / denominator of the way; the denominator is positive.
    struct Place {
        Int128 numerator = 0, denominator = 1;
        double rough = 0;  ///< with a relative error below 2^-50
    };
    struct Found {
        Place place;
        ContactClass kind = ContactClass::EdgeEdge;
        std::uint32_t clip = 0;
    };

    bool read(std::span<const Point> subject, std::span<const Point> clip);
    static Int128 cross(LatticePoint from, LatticePoint to, LatticePoint p);
    static Place place(Int128 numerator, Int128 denominator);
    static bool before(const Place& p, const Place& q);
    Int128 side(std::size_t vertex, std::size_t edge) const { return sides_[vertex * b_.size() + edge]; }
    void find_inside_edge(std::size_t i);
    bool part_is_outside(std::size_t i, const Place& from, const Place& to) const;
    std::optional<Contact> contact_at_vertex(std::size_t i) const;
    Point point_on_edge(std::size_t i, const Place& place) const;

    std::span<const Point> subject_, clip_;
    std::vector<LatticePoint> a_, b_;
    std::vector<Int128> sides_;  ///< twice the area of clip edge j and subject vertex i, at i * b_.size() + j
    std::vector<Found> on_edge_;  ///< of the edge being divided, along it
    std::vector<Contact> contacts_;
};

}  // namespace keikan::oracle
