// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "keikan/model/point.hpp"

namespace keikan {

/// The four classes of the paper (3.2.1): what of the subject lies on what of the clipper.
enum class ContactClass : std::uint8_t {
    EdgeEdge,       ///< (1) edges cross at a point that is a vertex of neither
    SubjectVertex,  ///< (2) a vertex of the subject lies inside an edge of the clipper
    ClipVertex,     ///< (3) a vertex of the clipper lies inside an edge of the subject
    SharedVertex,   ///< (4) a vertex of each lies at the same point
};

/// What the subject does there, in its direction of travel, with respect to the closed clipper.
enum class Turn : std::uint8_t {
    Enter,  ///< comes from strictly outside and does not go on strictly outside
    Leave,  ///< does not come from strictly outside and goes on strictly outside
    Touch,  ///< neither: it stays outside, or stays in the closed clipper
};

/// One place where the boundaries of subject and clipper meet in a vertex of either or by crossing.
struct Contact {
    ContactClass kind = ContactClass::EdgeEdge;
    Turn turn = Turn::Touch;
    std::uint32_t subject = 0;  ///< the vertex, or the start of the edge
    std::uint32_t clip = 0;     ///< the vertex, or the start of the edge
    Point point;                ///< the vertex itself; rounded only for EdgeEdge
    friend bool operator==(const Contact&, const Contact&) = default;
};

}  // namespace keikan
