// SPDX-License-Identifier: GPL-3.0-or-later
// The fast rung. One pixel is divided into convex cells, each with the one face that is seen in it:
//
//   a cell, the nearest face found for it so far, and the faces not yet looked at, most promising first
//     - no face is left that may be nearer: the cell belongs to the face found, or to the background
//     - else the next face divides the cell: outside it, inside and nearer than the face found, inside and
//     farther
//
// Every division is along a line of the question (exact_lines.hpp), every choice an exact sign. Faces are
// prepared when they are first needed; a face behind what covers the cell costs two comparisons.
#include <algorithm>
#include <cmath>
#include <limits>

#include "convex_outline.hpp"
#include "exact_areas.hpp"
#include "exact_lines.hpp"

namespace keikan::oracle {
namespace {

/// A corner of a convex cell, and the line along which its border goes on.
struct CellCorner {
    VertexId vertex;
    LineId line;
};

/// Counter-clockwise and strictly convex: `count` corners from `begin` on in a common store.
struct Cell {
    std::size_t begin = 0;
    std::size_t count = 0;
};

/// Pixel-local, rounded outwards.
struct Box {
    double x0, y0, x1, y1;

    bool apart_from(const Box& other) const {
        return x1 < other.x0 || other.x1 < x0 || y1 < other.y0 || other.y1 < y0;
    }
};

/// In rounding pixel-local coordinates of the pixel: more than any of them is off by.
constexpr double kBoxMargin = 0x1p-50;

struct Candidate {
    Box box;                      ///< of the outline within the pixel
    long double least, greatest;  ///< w over the box lies between
    enum { Untouched, ShowsNothing, Ready } state = Untouched;
    std::size_t first_edge = 0,
                last_edge = 0;  ///< the edges that may cross the pixel; interior to their left
};

/// Where a face is nearer than another.
struct Preference {
    enum { Nowhere, Everywhere, LeftOfLine } where = Nowhere;
    SidedLine line;
};

constexpr std::int32_t kNoFace = -1;

}  // namespace

struct CertifiedSplitting::Working {
    PixelIndex pixel;
    std::span<const FaceView> faces;
    Nearness nearness = Nearness::InOrder;
    ExactLines lines;
    std::vector<Candidate> candidates;
    std::vector<std::int32_t> order;  ///< of those that may touch the pixel, most promising first
    std::vector<SidedLine> edges;
    KeyTable preference_of_pair;
    std::vector<Preference> preferences;
    std::vector<CellCorner> corners;
    std::vector<Cell> outside;  ///< parts of a cell cut off so far
    std::vector<int> sides;     ///< of a cell's corners, the first repeated at the end
    std::vector<Point> ring;
    std::vector<UInt128> twice_area;  ///< of each face, then the background, in units of 2^-2 kFixedBits
    std::vector<double> extent;       ///< sum of width and height of the cells added

    void ask(PixelIndex pixel_asked, std::span<const FaceView> faces_asked, Nearness nearness_asked);
    CertifiedAreas answer() const;

    bool add_candidate(std::int32_t face);
    bool prepare(std::int32_t face);
    bool certainly_behind(std::int32_t face, std::int32_t found) const;
    Preference preference(std::int32_t face, std::int32_t over);
    int spread(const Cell& cell, SidedLine line);
    void split(const Cell& cell, SidedLine line, Cell& left, Cell& right);
    Box box_of(const Cell& cell) const;
    void resolve(Cell cell, std::int32_t found, std::size_t next);
    bool divide(const Cell& cell, std::int32_t face, std::int32_t found, std::size_t next);
    void add(const Cell& cell, std::int32_t face);
};

namespace {

enum Spread { kAllLeft = 1, kAllRight = -1, kBoth = 0 };

}  // namespace

/// False if the face cannot be seen in the pixel, because of its bounding box.
bool CertifiedSplitting::Working::add_candidate(std::int32_t face) {
    const FaceView& view = faces[static_cast<std::size_t>(face)];
    Candidate& candidate = candidates[static_cast<std::size_t>(face)];
    candidate = {};
    if (view.outline.size() < 3) return false;
    double x0 = view.outline[0].x, x1 = x0, y0 = view.outline[0].y, y1 = y0;
    for (const Point& p : view.outline.subspan(1)) {
        x0 = std::min(x0, p.x);
        x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y);
        y1 = std::max(y1, p.y);
    }
    if (x0 >= pixel.x + 1 || x1 <= pixel.x || y0 >= pixel.y + 1 || y1 <= pixel.y) return false;
    const Box box = {std::max(x0 - pixel.x, 0.0) - kBoxMargin, std::max(y0 - pixel.y, 0.0) - kBoxMargin,
                     std::min(x1 - pixel.x, 1.0) + kBoxMargin, std::min(y1 - pixel.y, 1.0) + kBoxMargin};
    candidate.box = box;
    if (nearness == Nearness::InOrder) return true;

    // In 64 bits each product and sum errs by 2^-64 of its size; there are eight, so 2^-60 covers them.
    const long double a = view.depth.a, b = view.depth.b, c = view.depth.c;
    const long double error = 0x1p-60L * (std::abs(a) * (std::abs(pixel.x) + 2) +
                                          std::abs(b) * (std::abs(pixel.y) + 2) + std::abs(c));
    const long double here = a * pixel.x + b * pixel.y + c;
    candidate.least = here + std::min(a * box.x0, a * box.x1) + std::min(b * box.y0, b * box.y1) - error;
    candidate.greatest = here + std::max(a * box.x0, a * box.x1) + std::max(b * box.y0, b * box.y1) + error;
    return true;
}

void CertifiedSplitting::Working::ask(PixelIndex pixel_asked, std::span<const FaceView> faces_asked,
                                      Nearness nearness_asked) {
    pixel = pixel_asked;
    faces = faces_asked;
    nearness = nearness_asked;
    lines.start(pixel);
    candidates.resize(faces.size());
    order.clear();
    edges.clear();
    preference_of_pair.forget_all();
    preferences.clear();
    twice_area.assign(faces.size() + 1, 0);
    extent.assign(faces.size() + 1, 0);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(faces.size()); ++i)
        if (add_candidate(i)) order.push_back(i);
    if (nearness == Nearness::ByDepth)
        std::ranges::stable_sort(order, [this](std::int32_t i, std::int32_t j) {
            return candidates[static_cast<std::size_t>(i)].greatest >
                   candidates[static_cast<std::size_t>(j)].greatest;
        });
    corners = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
    resolve({0, 4}, kNoFace, 0);
}

/// False if the face shows nothing in the pixel.
bool CertifiedSplitting::Working::prepare(std::int32_t face) {
    Candidate& candidate = candidates[static_cast<std::size_t>(face)];
    if (candidate.state != Candidate::Untouched) return candidate.state == Candidate::Ready;
    candidate.state = Candidate::ShowsNothing;
    convex_outline(faces[static_cast<std::size_t>(face)].outline, ring);
    candidate.first_edge = edges.size();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point p = ring[i], q = ring[i + 1 < ring.size() ? i + 1 : 0];
        const PixelSide side = pixel_side(p, q, pixel);
        if (side == PixelSide::Right) return false;
        if (side == PixelSide::Unknown) edges.push_back(lines.line_through(p, q));
    }
    candidate.last_edge = edges.size();
    if (!ring.empty()) candidate.state = Candidate::Ready;
    return !ring.empty();
}

/// `face`, and all that follow it in `order`, are nowhere nearer than `found`.
bool CertifiedSplitting::Working::certainly_behind(std::int32_t face, std::int32_t found) const {
    if (found == kNoFace) return false;
    if (nearness == Nearness::InOrder) return true;
    return candidates[static_cast<std::size_t>(face)].greatest <
           candidates[static_cast<std::size_t>(found)].least;
}

/// Requires: ByDepth.
Preference CertifiedSplitting::Working::preference(std::int32_t face, std::int32_t over) {
    const Candidate& candidate = candidates[static_cast<std::size_t>(face)];
    if (candidate.least > candidates[static_cast<std::size_t>(over)].greatest)
        return {Preference::Everywhere, {}};
    const FaceView& nearer = faces[static_cast<std::size_t>(face)];
    const FaceView& farther = faces[static_cast<std::size_t>(over)];
    const DepthPlane &u = nearer.depth, &v = farther.depth;
    if (u.a == v.a && u.b == v.b) {
        const bool smaller = nearer.id != farther.id ? nearer.id < farther.id : face < over;
        const bool wins = u.c != v.c ? u.c > v.c : smaller;
        return {wins ? Preference::Everywhere : Preference::Nowhere, {}};
    }
    const bool swapped = over < face;
    const auto first = static_cast<std::uint64_t>(swapped ? over : face);
    const auto second = static_cast<std::uint64_t>(swapped ? face : over);
    std::int32_t& line = preference_of_pair.value({first, second}, -1);
    if (line < 0) line = (swapped ? lines.line_of_equal_depth(v, u) : lines.line_of_equal_depth(u, v)).line;
    return {Preference::LeftOfLine, {line, swapped ? -1 : 1}};
}

/// On which sides of the line the cell has points; leaves the corners' sides in `sides`.
int CertifiedSplitting::Working::spread(const Cell& cell, SidedLine line) {
    bool left = false, right = false;
    sides.resize(cell.count + 1);
    for (std::size_t i = 0; i < cell.count; ++i) {
        const int side = lines.side(corners[cell.begin + i].vertex, line);
        sides[i] = side;
        left = left || side > 0;
        right = right || side < 0;
    }
    sides[cell.count] = sides[0];
    return left && right ? kBoth : left ? kAllLeft : kAllRight;
}

/// Requires: `sides` from `spread`, which gave kBoth. The halves are new cells at the end of the store.
void CertifiedSplitting::Working::split(const Cell& cell, SidedLine line, Cell& left, Cell& right) {
    VertexId cut[2] = {0, 0};  // where the border crosses to the right, and to the left again
    LineId beyond[2] = {0, 0};
    std::size_t last_left = 0, last_right = 0;
    for (std::size_t i = 0; i < cell.count; ++i) {
        const int here = sides[i], next = sides[i + 1];
        const CellCorner corner = corners[cell.begin + i];
        if (here > 0 && next <= 0) last_left = i;
        if (here < 0 && next >= 0) last_right = i;
        const int crossing = here * next < 0 ? (here > 0 ? 0 : 1) : -1;
        if (crossing >= 0) {
            cut[crossing] = lines.meeting_point(corner.line, line.line);
            beyond[crossing] = corner.line;
        } else if (here == 0) {
            const int way = next < 0 ? 0 : 1;
            cut[way] = corner.vertex;
            beyond[way] = corner.line;
        }
    }
    const auto half = [&](int side, std::size_t last, int leaves) {
        const std::size_t begin = corners.size();
        // Backwards from `last` lies the run of corners on this side.
        std::size_t first = last;
        while (sides[(first + cell.count - 1) % cell.count] == side)
            first = (first + cell.count - 1) % cell.count;
        corners.push_back({cut[1 - leaves], beyond[1 - leaves]});
        for (std::size_t i = first;; i = (i + 1) % cell.count) {
            corners.push_back(corners[cell.begin + i]);
            if (i == last) break;
        }
        corners.push_back({cut[leaves], line.line});
        return Cell{begin, corners.size() - begin};
    };
    left = half(1, last_left, 0);
    right = half(-1, last_right, 1);
}

Box CertifiedSplitting::Working::box_of(const Cell& cell) const {
    Box box = {1, 1, 0, 0};
    for (std::size_t i = 0; i < cell.count; ++i) {
        const ExactLines::Vertex& v = lines.vertex(corners[cell.begin + i].vertex);
        box = {std::min(box.x0, v.x), std::min(box.y0, v.y), std::max(box.x1, v.x), std::max(box.y1, v.y)};
    }
    return {box.x0 - kBoxMargin, box.y0 - kBoxMargin, box.x1 + kBoxMargin, box.y1 + kBoxMargin};
}

/// Divides the cell, of which `found` is the nearest face so far, among it and the faces order[next], ...
void CertifiedSplitting::Working::resolve(Cell cell, std::int32_t found, std::size_t next) {
    if (next < order.size() && !certainly_behind(order[next], found)) {
        const Box box = box_of(cell);
        for (; next < order.size(); ++next) {
            const std::int32_t face = order[next];
            if (certainly_behind(face, found)) break;
            if (box.apart_from(candidates[static_cast<std::size_t>(face)].box)) continue;
            if (divide(cell, face, found, next + 1)) return;
        }
    }
    add(cell, found);
}

/// False if the face shows nothing of itself in the cell; then nothing has changed.
bool CertifiedSplitting::Working::divide(const Cell& cell, std::int32_t face, std::int32_t found,
                                         std::size_t next) {
    Preference over_found{Preference::Everywhere, {}};
    if (found != kNoFace) {
        over_found = preference(face, found);
        if (over_found.where == Preference::Nowhere) return false;
        if (over_found.where == Preference::LeftOfLine) {
            const int sides_seen = spread(cell, over_found.line);
            if (sides_seen == kAllRight) return false;
            if (sides_seen == kAllLeft) over_found.where = Preference::Everywhere;
        }
    }
    if (!prepare(face)) return false;

    const Candidate candidate = candidates[static_cast<std::size_t>(face)];
    for (std::size_t i = candidate.first_edge; i < candidate.last_edge; ++i)
        if (spread(cell, edges[i]) == kAllRight) return false;

    const std::size_t corner_mark = corners.size(), vertex_mark = lines.vertex_count();
    const std::size_t outside_mark = outside.size();
    const auto take_back = [&] {
        corners.resize(corner_mark);
        outside.resize(outside_mark);
        lines.forget_vertices_from(vertex_mark);
    };
    Cell inside = cell;
    for (std::size_t i = candidate.first_edge; i < candidate.last_edge; ++i) {
        const int sides_seen = spread(inside, edges[i]);
        if (sides_seen == kAllLeft) continue;
        if (sides_seen == kAllRight) return take_back(), false;
        Cell left, right;
        split(inside, edges[i], left, right);
        outside.push_back(right);
        inside = left;
    }
    Cell farther;
    if (over_found.where == Preference::LeftOfLine) {
        const int sides_seen = spread(inside, over_found.line);
        if (sides_seen == kAllRight) return take_back(), false;
        if (sides_seen == kBoth) {
            Cell nearer;
            split(inside, over_found.line, nearer, farther);
            inside = nearer;
        }
    }
    const std::size_t outside_end = outside.size();
    for (std::size_t i = outside_mark; i < outside_end; ++i) resolve(Cell(outside[i]), found, next);
    if (farther.count > 0) resolve(farther, found, next);
    resolve(inside, face, next);
    take_back();
    return true;
}

void CertifiedSplitting::Working::add(const Cell& cell, std::int32_t face) {
    const std::size_t owner = face == kNoFace ? faces.size() : static_cast<std::size_t>(face);
    std::int64_t x0 = std::numeric_limits<std::int64_t>::max(), x1 = 0, y0 = x0, y1 = 0;
    UInt128 twice = 0;  // wraps around on the way; the sum itself is at most 2^125
    const ExactLines::Vertex* p = &lines.vertex(corners[cell.begin + cell.count - 1].vertex);
    for (std::size_t i = 0; i < cell.count; ++i) {
        const ExactLines::Vertex* q = &lines.vertex(corners[cell.begin + i].vertex);
        twice += static_cast<UInt128>(static_cast<Int128>(p->fixed_x) * q->fixed_y);
        twice -= static_cast<UInt128>(static_cast<Int128>(q->fixed_x) * p->fixed_y);
        x0 = std::min(x0, q->fixed_x);
        x1 = std::max(x1, q->fixed_x);
        y0 = std::min(y0, q->fixed_y);
        y1 = std::max(y1, q->fixed_y);
        p = q;
    }
    twice_area[owner] += twice;
    extent[owner] += 0x1p-62 * (static_cast<double>(x1 - x0) + static_cast<double>(y1 - y0)) + 0x1p-58;
}

/// A cell's corners are off by at most d = kVertexError each way. With p_i its corners, its area is off by
/// half the sum of e_i x (p_(i+1) - p_(i-1)), at most 2 d (width + height) because its border goes there and
/// back once, and by terms of d^2 (with the rounding of width and height: the 2^-58 added in `add`).
CertifiedAreas CertifiedSplitting::Working::answer() const {
    CertifiedAreas result;
    UInt128 total = 0;
    double total_error = 0;
    const auto area_of = [&](std::size_t owner) {
        const auto twice = static_cast<Int128>(twice_area[owner]);
        const double error = 2 * ExactLines::kVertexError * extent[owner] * (1 + 0x1p-40);
        total += twice_area[owner];
        total_error += error;
        const double value = std::ldexp(static_cast<double>(twice), -2 * ExactLines::kFixedBits - 1);
        return CertifiedArea{value, error + 0x1p-53 * std::abs(value)};
    };
    for (std::size_t i = 0; i < faces.size(); ++i) result.areas.push_back(area_of(i));
    result.background = area_of(faces.size());

    // The cells divide the pixel: a slip of the combinatorics would show here.
    const auto missing =
        static_cast<Int128>(total) - (static_cast<Int128>(1) << (2 * ExactLines::kFixedBits + 1));
    result.certified =
        std::abs(std::ldexp(static_cast<double>(missing), -2 * ExactLines::kFixedBits - 1)) <= total_error;
    if (!result.certified) result.areas.clear();
    return result;
}

namespace {

bool all_finite(std::span<const FaceView> faces, Nearness nearness) {
    for (const FaceView& face : faces) {
        for (const Point& p : face.outline)
            if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
        const DepthPlane& plane = face.depth;
        if (nearness == Nearness::ByDepth &&
            !(std::isfinite(plane.a) && std::isfinite(plane.b) && std::isfinite(plane.c)))
            return false;
    }
    return true;
}

}  // namespace

CertifiedSplitting::CertifiedSplitting() : working_(new Working) {}
CertifiedSplitting::~CertifiedSplitting() {
    delete working_;
}

CertifiedAreas CertifiedSplitting::operator()(PixelIndex pixel, std::span<const FaceView> faces,
                                              Nearness nearness) {
    if (!all_finite(faces, nearness)) return {};
    working_->ask(pixel, faces, nearness);
    return working_->answer();
}

}  // namespace keikan::oracle
