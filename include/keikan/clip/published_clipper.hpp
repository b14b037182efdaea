// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "keikan/clip/classify_intersections.hpp"
#include "keikan/model/clip_step.hpp"
#include "keikan/model/point.hpp"

namespace keikan {

/// Where the paper is silent or where its rule does not hold up, one choice each. The defaults are the paper
/// as printed; what it leaves open is read as Weiler and Atherton, whom it follows, would.
struct PublishedReading {
    enum class Start {
        AnyVertex,      ///< 3.2.2 (1) to the letter: any vertex of the subject not yet visited
        OutsideVertex,  ///< a vertex strictly outside the clipper: what a search for the outside must mean
    };
    enum class Hole {
        Deferred,  ///< Fig. 3: the area of j is subtracted at the end (departure D2: twice, where a later j
                   ///< overlaps)
        Signed,    ///< a piece of sign -1 that later clippers clip
    };
    enum class SharedVertex {
        AsPrinted,  ///< 3.2.1 case (4)
        OneRule,    ///< departure D1: the rule of cases (2) and (3)
    };
    Start start = Start::OutsideVertex;
    Hole hole = Hole::Deferred;
    SharedVertex shared_vertex = SharedVertex::AsPrinted;
};

/// What went wrong along the way; the paper has no word for any of these.
struct PublishedTroubles {
    std::uint64_t did_not_close = 0;      ///< searches that the loop guard ended
    std::uint64_t odd_intersections = 0;  ///< clip steps with an odd number of intersections
};

/// Section 3.2 as printed, in plain double arithmetic: Fig. 3, the four cases of 3.2.1 and the search
/// of 3.2.2, to be read with the paper open beside it. It is studied, not used: its areas may be wrong.
///
/// Properties:
///   (1) It ends: a search takes at most as many steps as there are vertices and intersections, twice over,
///       and the pieces of one face number at most kMostPieces.
///   (2) Nothing is checked or repaired; `troubles` counts what a careful reader would have noticed.
///
/// Requires: convex polygons, nearest first, clockwise as seen on the screen (y down: from +x towards +y).
/// Paper:    section 3.2 whole.
class PublishedClipper {
  public:
    explicit PublishedClipper(PublishedReading reading = {}) : reading_(reading) {}

    static constexpr std::size_t kMostPieces = 4096;

    /// A vertex list with its sign, and the areas that Fig. 3 remembers to subtract from it.
    struct Piece {
        Ring ring;
        int sign = 1;
        double to_subtract = 0;
    };

    /// The visible area of each polygon, step (6) included, in the units of the coordinates.
    std::vector<double> visible_areas(std::span<const Ring> polygons);

    /// The intersections of subject A with clipper B (3.2.1), in the order of travel along A. `turn` is the
    /// parity of the search: Enter for odd-numbered ones from a start outside, Leave for even-numbered ones.
    std::vector<Contact> intersections(const Ring& a, const Ring& b) const;

    /// The pieces of A outside B (3.2.2).
    std::vector<Ring> search_vertices(const Ring& a, const Ring& b, std::span<const Contact> intersections);

    /// The pieces of polygon i in the last visible_areas; an empty ring is one that a later polygon hid
    /// wholly.
    std::span<const Piece> pieces_of(std::size_t i) const { return pieces_[i]; }

    const PublishedTroubles& troubles() const { return troubles_; }

    /// Every clip step of the calls to come is shown to `observer`: a piece, the polygon that clips it, and
    /// `intersections` of the two; the faces are positions in `polygons`.
    void observe(std::function<void(const ClipStep&)> observer) { observer_ = std::move(observer); }

  private:
    bool clip_piece(std::vector<Piece>& pieces, std::size_t k, const Ring& b, std::vector<Piece>& appended);
    void show_step(const Piece& piece, const Ring& b, std::size_t i, std::size_t j) const;

    PublishedReading reading_;
    std::vector<std::vector<Piece>> pieces_;  ///< of polygon i; n[i] of Fig. 3 is pieces_[i].size()
    PublishedTroubles troubles_;
    std::function<void(const ClipStep&)> observer_;
};

}  // namespace keikan
