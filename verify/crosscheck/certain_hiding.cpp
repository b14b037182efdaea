// SPDX-License-Identifier: GPL-3.0-or-later
#include "certain_hiding.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace keikan::crosscheck {
namespace {

constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;

/// +1 or -1 where c lies certainly left or right of a -> b (positive turns from +x towards +y), else 0.
/// Two differences, two products and their difference are rounded: at most (3 + 16 u) u (|l| + |r|), u =
/// 2^-53 (Shewchuk 1997, the bound called A there); 4 u leaves room for the rounding of the bound itself. The
/// constant covers underflow.
int certain_side(Point a, Point b, Point c) {
    const double l = (b.x - a.x) * (c.y - a.y);
    const double r = (b.y - a.y) * (c.x - a.x);
    const double value = l - r;
    const double error = 4 * kHalfUlp * (std::abs(l) + std::abs(r)) + std::numeric_limits<double>::min();
    return value > error ? 1 : value < -error ? -1 : 0;
}

std::array<Point, 4> corners_of(PixelIndex pixel) {
    const double x = pixel.x, y = pixel.y;
    return {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
}

/// The turn of `outline` if it is certainly strictly convex and goes round once; else 0.
std::int8_t certain_orientation(std::span<const Point> outline) {
    const std::size_t n = outline.size();
    if (n < 3) return 0;
    const int turn = certain_side(outline[0], outline[1], outline[2]);
    // Every corner on the inner side of every edge.
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 2; k < n; ++k)
            if (certain_side(outline[i], outline[(i + 1) % n], outline[(i + k) % n]) != turn) return 0;
    return static_cast<std::int8_t>(turn);
}

}  // namespace

CertainHiding::CertainHiding(const ProjectedFaces& faces) : faces_(faces), orientation_(faces.size()) {
    for (std::size_t i = 0; i < faces.size(); ++i) orientation_[i] = certain_orientation(faces[i].outline);
}

CertainHiding::Relation CertainHiding::relation(std::uint32_t face, PixelIndex pixel) const {
    const int turn = orientation_[face];
    if (turn == 0) return Relation::Unknown;
    const auto outline = faces_[face].outline;
    const auto corners = corners_of(pixel);
    bool covers = true;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point& from = outline[i];
        const Point& to = outline[i + 1 < outline.size() ? i + 1 : 0];
        bool all_beyond = true;
        for (const Point& corner : corners) {
            const int side = certain_side(from, to, corner) * turn;
            all_beyond = all_beyond && side < 0;
            covers = covers && side > 0;
        }
        if (all_beyond) return Relation::Outside;
    }
    return covers ? Relation::Covers : Relation::Unknown;
}

bool CertainHiding::hides(std::uint32_t cover, std::uint32_t face, PixelIndex pixel) const {
    const DepthPlane& near = faces_.plane[cover];
    const DepthPlane& far = faces_.plane[face];
    const double a = near.a - far.a, b = near.b - far.b, c = near.c - far.c;
    for (const Point& corner : corners_of(pixel)) {
        const double ahead = a * corner.x + b * corner.y + c;
        // Each term is rounded when it is subtracted, multiplied and added (twice): at most 4 u of its
        // magnitude.
        const double magnitude = (std::abs(near.a) + std::abs(far.a)) * std::abs(corner.x) +
                                 (std::abs(near.b) + std::abs(far.b)) * std::abs(corner.y) +
                                 std::abs(near.c) + std::abs(far.c);
        if (!(ahead > 8 * kHalfUlp * magnitude + std::numeric_limits<double>::min())) return false;
    }
    return true;  // the difference is affine: positive at the corners, positive in the pixel
}

void CertainHiding::operator()(PixelIndex pixel, std::span<const std::uint32_t> candidates,
                               Remaining& out) const {
    out.faces.clear();
    out.cover.reset();
    double cover_nearness = 0;
    for (const std::uint32_t face : candidates) {
        const Relation found = relation(face, pixel);
        if (found == Relation::Outside) continue;
        out.faces.push_back(face);
        if (found != Relation::Covers) continue;
        const DepthPlane& plane = faces_.plane[face];
        const double nearness = plane.a * (pixel.x + 0.5) + plane.b * (pixel.y + 0.5) + plane.c;
        if (!out.cover || nearness > cover_nearness) {
            out.cover = face;
            cover_nearness = nearness;
        }
    }
    if (out.cover)
        std::erase_if(out.faces, [&](std::uint32_t face) {
            return face != *out.cover && hides(*out.cover, face, pixel);
        });
}

}  // namespace keikan::crosscheck
