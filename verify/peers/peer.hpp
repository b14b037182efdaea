// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "peers/prepared_pixel.hpp"

namespace keikan::peers {

/// What a peer says about a pixel.
struct Answer {
    std::vector<double> areas;  ///< one for each face: the visible fraction of the pixel
    double background = 1;
    friend bool operator==(const Answer&, const Answer&) = default;
};

/// Asks about one pixel. Whatever it throws is a failure of the peer; it may also crash or never return
/// (forked_run.hpp takes care of that). `answer` keeps its memory from call to call.
using Ask = std::function<void(const PreparedPixel& pixel, Answer& answer)>;

/// Whoever can divide a pixel among faces: a library, sampling, our own engines, a planted wrong-doer.
struct Peer {
    std::string name;
    std::string version;
    bool by_depth = false;       ///< can be asked with Nearness::ByDepth
    std::function<Ask()> start;  ///< ready to be asked by one thread or one process
};

// How each is used, and why so: docs/peers.md. The libraries see PreparedPixel::in_pixel, nearest first, take
// the nearer polygons away from each, and call the background what the areas leave of 1.

/// boost::geometry::difference, one nearer polygon after the other.
Peer boost_geometry();
/// The same of Boost 1.81, where the build found its headers (scripts/boost_1_81).
std::optional<Peer> boost_geometry_1_81();
/// GEOSDifference (OverlayNG), one nearer polygon after the other.
Peer geos();
/// Clipper 6.4.2 on a grid of 2^-60 pixel: one ctDifference a polygon, all nearer ones as its clip.
Peer clipper();
/// CGAL's Boolean set operations with inexact constructions, which its manual advises against.
Peer cgal_inexact();
/// CGAL's Boolean set operations with exact constructions, as its manual advises.
Peer cgal_exact();
/// side * side sample points on a regular grid. Requires: 1 <= side <= kMostSamplesAside.
Peer sampling(int side);
inline constexpr int kMostSamplesAside = 64;
/// keikan::VisibleAreas; they see the faces as they come.
Peer splitting();
Peer traversal();
Peer published();

}  // namespace keikan::peers
