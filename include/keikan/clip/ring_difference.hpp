// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "keikan/clip/classify_intersections.hpp"
#include "keikan/model/point.hpp"

namespace keikan {

/// A region as a sum of signed rings: a point belongs to it as often as the sum of sign * winding number
/// says, 0 or 1 for a region. A hole is a ring of sign -1 that later clippers clip like any other
/// (departure D2); a piece may touch itself. Reused storage: `clear` keeps the memory.
class SignedRings {
  public:
    struct Piece {
        int sign = 1;
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };

    void clear();
    void add(std::span<const Point> ring, int sign);
    /// The same for a ring of three points or more, consecutive ones of which differ.
    void append(std::span<const Point> ring, int sign);
    /// Adding a ring point by point. Repeated points are left out; a ring of fewer than three is dropped.
    void add_point(Point p) {
        if (end_ > open_ && points_[end_ - 1] == p) return;
        if (end_ == points_.size()) [[unlikely]]
            make_room(1);
        points_[end_++] = p;
    }
    void close_ring(int sign);

    std::size_t size() const { return pieces_.size(); }
    bool empty() const { return pieces_.empty(); }
    int sign(std::size_t i) const { return pieces_[i].sign; }
    std::span<const Point> ring(std::size_t i) const {
        return std::span(points_).subspan(pieces_[i].begin, pieces_[i].end - pieces_[i].begin);
    }

  private:
    void make_room(std::size_t more);

    std::vector<Point> points_;  ///< as many as there have ever been
    std::vector<Piece> pieces_;
    std::uint32_t open_ = 0;  ///< where the ring being added begins
    std::uint32_t end_ = 0;   ///< where its next point goes
};

/// Twice the signed area of `ring`, positive when it turns from +x towards +y, measured from its first point.
double twice_signed_area(std::span<const Point> ring);

/// What is left of a ring outside a convex clipper: the paper's vertex search (3.2.2), mended. One object a
/// thread.
///
/// The result follows the subject outside the clipper and the clipper's outline, against its direction,
/// from each entry to an exit. How often each stretch of that outline is walked is not searched for but
/// known: an Enter takes one walk away from the stretch behind it, a Leave adds one, and next to the end of
/// clipper edge 0 the number is IntersectionClassifier::winding_outside_first_edge. So no loop can stay
/// open and no whole copy of the clipper is lost or gained, whatever rounding did to the subject.
///
/// Properties:
///   (1) The winding number of the result is that of `subject` outside `clip`, and 0 inside it, but for
///       the rounding of EdgeEdge points.
///   (2) A subject inside the closed clipper leaves nothing; one that only surrounds the clipper stays, with
///       the clipper as a ring of the opposite sign.
///   (3) Rings turn as `subject` turns; whole copies of the clipper turn from +x towards +y.
///   (4) Subtracting the same clipper again changes nothing.
///   (5) Starting either ring elsewhere leaves the same region; reversing `subject` turns its sign round.
///
/// Requires: as IntersectionClassifier.
/// Cost:     that of classifying, and a sort of the turns along the clipper.
/// Paper:    section 3.2.2, Fig. 5. Departures D2 (signed holes), D3, D4 (pieces that touch themselves).
class RingDifference {
  public:
    explicit RingDifference(IntersectionClassifier::Lattice lattice) : classify_(lattice) {}

    /// Appends `subject` outside `clip`, times `sign`, to `rest`.
    void operator()(std::span<const Point> subject, int sign, std::span<const Point> clip, SignedRings& rest);

    /// The first half of that: how the rings lie. What is not Apart goes on with the second half.
    IntersectionClassifier::Position position(std::span<const Point> subject, std::span<const Point> clip);
    /// The second half, for the rings of the last `position`.
    void append_rest(int sign, SignedRings& rest);

    /// The contacts of the last call, whose rings must still be there. They are found only now if the rings
    /// lie so that none was needed (IntersectionClassifier::Position).
    std::span<const Contact> contacts();

    /// Calls in which rounding had folded the subject over itself at the clipper's outline, so that a stretch
    /// is walked other than 0 or 1 times. The area is right all the same; the rings overlap there.
    std::uint64_t folds() const { return folds_; }

  private:
    using Position = IntersectionClassifier::Position;
    /// A contact that enters or leaves.
    struct TurnOnClip {
        std::uint32_t contact = 0;  ///< into contacts_
        std::uint32_t rank = 0;     ///< edges of the clipper passed since the end of edge 0
        bool leave = false;
        bool followed = false;   ///< of a Leave: a ring goes through it
        std::uint32_t exit = 0;  ///< of an Enter: the turn at which its walk ends
        std::uint32_t walk = 0;  ///< of an Enter: the clipper's vertices on its walk
    };
    /// A turn, where it lies along the clipper's outline.
    struct Station {
        std::uint32_t turn = 0;  ///< into turns_
        std::uint32_t rank = 0;
        double along = 0;
        bool leave = false;
    };

    void find_turns();
    double along_edge(const TurnOnClip& turn) const;
    int join_two(int walks);
    int join_all(int walks);
    void sort_stations();
    int order_by_walks(int walks);
    void match_walks();
    void follow_rings(int sign, SignedRings& rest);
    void follow_outside(std::size_t leave_turn, SignedRings& rest);
    void walk_back(const TurnOnClip& enter, SignedRings& rest);

    IntersectionClassifier classify_;
    std::span<const Point> subject_;
    std::span<const Point> clip_;
    Position position_ = Position::Apart;
    std::span<const Contact> contacts_;
    std::vector<TurnOnClip> turns_;  ///< along the subject
    std::vector<Station> stations_;  ///< along the clipper
    std::vector<Station> open_leaves_;
    std::uint64_t folds_ = 0;
};

}  // namespace keikan
