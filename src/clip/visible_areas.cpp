// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/visible_areas.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "apart.hpp"
#include "convex_outline.hpp"
#include "double_double.hpp"
#include "nearer_part.hpp"
#include "keikan/clip/published_clipper.hpp"
#include "partition.hpp"
#include "traversal.hpp"

namespace keikan {
namespace {

using clip::Box;
using clip::ConvexOutline;
using clip::DoubleDouble;
using clip::EdgeView;
using clip::Entrant;
using clip::kHalfUlp;
using clip::Overlap;
using clip::Partition;
using clip::Turning;

constexpr Point kPixelRing[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// An interval that certainly holds w over the whole pixel.
struct DepthRange {
    double min = 0, max = 0;
};

DepthRange depth_range(PixelIndex pixel, const DepthPlane& plane) {
    const double ax = plane.a * pixel.x, by = plane.b * pixel.y;
    const double corner = plane.c + ax + by;
    // Two products, two sums, and two more sums with the slopes below.
    const double error =
        8 * kHalfUlp *
        (std::abs(plane.c) + std::abs(ax) + std::abs(by) + std::abs(plane.a) + std::abs(plane.b));
    return {corner + std::min(plane.a, 0.0) + std::min(plane.b, 0.0) - error,
            corner + std::max(plane.a, 0.0) + std::max(plane.b, 0.0) + error};
}

/// A face that may have area in the pixel, before it is clipped.
struct Candidate {
    std::uint32_t position = 0;
    ConvexOutline outline;
    Overlap overlap = Overlap::Nothing;
    std::size_t views = 0;  ///< where the views of its edges start
    DepthRange depth;
};

/// A sum of many numbers as if in twice the precision (Neumaier 1974).
class CarefulSum {
  public:
    void add(double value) {
        const DoubleDouble sum = clip::two_sum(sum_, value);
        sum_ = sum.hi;
        rest_ += sum.lo;
    }
    double value() const { return sum_ + rest_; }

  private:
    double sum_ = 0, rest_ = 0;
};

/// Area and first moments.
struct Measure {
    CarefulSum area, x, y;

    /// Adds a ring, seen from its first corner: differences are exact, and the terms as small as the ring.
    void add(std::span<const Point> ring, int sign = 1) {
        const Point from = ring[0];
        double twice_area = 0, moment_x = 0, moment_y = 0;
        double ux = ring[1].x - from.x, uy = ring[1].y - from.y;
        for (std::size_t i = 2; i < ring.size(); ++i) {
            const double vx = ring[i].x - from.x, vy = ring[i].y - from.y;
            const double cross = ux * vy - uy * vx;
            twice_area += cross;
            moment_x += cross * (ux + vx);
            moment_y += cross * (uy + vy);
            ux = vx, uy = vy;
        }
        twice_area *= sign, moment_x *= sign, moment_y *= sign;
        area.add(0.5 * twice_area);
        x.add(0.5 * twice_area * from.x + moment_x / 6);
        y.add(0.5 * twice_area * from.y + moment_y / 6);
    }
};

}  // namespace

struct VisibleAreas::Working {
    PixelIndex pixel;
    Nearness nearness = Nearness::InOrder;
    std::vector<Candidate> candidates;
    std::vector<EdgeView> views;
    std::vector<std::vector<Point>> hulls;  ///< of outlines that are not strictly convex as given
    std::size_t hulls_used = 0;
    std::vector<Point> scratch;
    clip::Entrants entrants;
    Partition partition;
    std::vector<Measure> measures;
    std::vector<VisiblePart> parts;
    std::vector<VisiblePiece> pieces;
    bool divided = false;  ///< `partition` is that of the last call
    Engine engine = Engine::Splitting;
    clip::Traversal traversal;
    clip::Traversal::Observer observer;
    SignedRings rings;                       ///< of all faces, where the engine gives outlines
    std::vector<std::uint32_t> ring_owner;  ///< into entrants.faces, or Partition::kFree
    std::vector<VisibleOutline> outlines;
    PublishedClipper published;

    void gather(std::span<const FaceView> faces);
    void enter(std::span<const FaceView> faces);
    void put_in_order();
    void divide(Nearness by);
    PixelCoverage split_pixel(std::span<const FaceView> faces);
    PixelCoverage split_faces_apart();
    void add_part(const Entrant& face, const Measure& measure);
    PixelCoverage traverse_pixel();
    PixelCoverage publish_pixel();
    PixelCoverage coverage(const Measure& free);

    ConvexOutline convex(std::span<const Point> outline);
    void measure_depth(Entrant& entrant);
    void measure_depths(std::span<const FaceView> faces);
    bool before(const Entrant& p, const Entrant& q) const;
};

/// The outline if it is strictly convex as it stands, else its hull.
ConvexOutline VisibleAreas::Working::convex(std::span<const Point> outline) {
    const Turning turning = clip::turning(outline);
    if (turning != Turning::NotStrictlyConvex) return {outline, turning == Turning::Negative};
    if (hulls_used == hulls.size()) hulls.emplace_back();
    std::vector<Point>& hull = hulls[hulls_used++];
    hull.assign(outline.begin(), outline.end());
    clip::replace_by_hull(hull);
    return {hull, false};
}

/// Finds the faces that may have area in the pixel and are not hidden as a whole by one that covers it.
void VisibleAreas::Working::gather(std::span<const FaceView> faces) {
    candidates.clear();
    views.clear();
    hulls_used = 0;
    double hidden_below = -HUGE_VAL;  // the largest w below which a face that covers the pixel hides all
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!clip::may_overlap(pixel, faces[i].outline)) continue;
        Candidate candidate;
        candidate.position = static_cast<std::uint32_t>(i);
        candidate.outline = convex(faces[i].outline);
        if (candidate.outline.size() < 3) continue;
        candidate.views = views.size();
        candidate.overlap = clip::overlap(pixel, candidate.outline, views);
        if (candidate.overlap == Overlap::Nothing) continue;
        const bool whole = candidate.overlap == Overlap::WholePixel;
        if (nearness == Nearness::ByDepth) {
            candidate.depth = depth_range(pixel, faces[i].depth);
            if (whole) hidden_below = std::max(hidden_below, candidate.depth.min);
        }
        candidates.push_back(candidate);
        if (whole && nearness == Nearness::InOrder) break;
    }
    if (nearness == Nearness::ByDepth)
        std::erase_if(candidates, [&](const Candidate& c) { return c.depth.max < hidden_below; });
}

void VisibleAreas::Working::measure_depth(Entrant& entrant) {
    const clip::LocalPlane& plane = entrant.plane;
    entrant.w_min = HUGE_VAL, entrant.w_max = -HUGE_VAL;
    for (const Point p : entrants.ring(entrant)) {
        const double w = plane.c.hi + (plane.a * p.x + plane.b * p.y);
        entrant.w_min = std::min(entrant.w_min, w);
        entrant.w_max = std::max(entrant.w_max, w);
    }
    entrant.w_error = 5 * kHalfUlp * (std::abs(plane.a) + std::abs(plane.b) + std::abs(plane.c.hi));
}

/// Clips the candidates to the pixel.
void VisibleAreas::Working::enter(std::span<const FaceView> faces) {
    entrants.clear();
    for (const Candidate& candidate : candidates) {
        const auto of_candidate = std::span(views).subspan(candidate.views, candidate.outline.size());
        const std::span<const Point> ring =
            candidate.overlap == Overlap::WholePixel
                ? std::span<const Point>(kPixelRing)
                : clip::clip_to_pixel(pixel, candidate.outline, of_candidate, scratch);
        if (ring.empty()) continue;
        Entrant& entrant = entrants.faces.emplace_back();
        entrant.position = candidate.position;
        entrant.id = faces[candidate.position].id;
        entrant.ring = static_cast<std::uint32_t>(entrants.corners.size());
        entrant.size = static_cast<std::uint32_t>(ring.size());
        entrant.box = {1, 1, 0, 0};
        for (const Point p : ring) {
            entrant.box.min_x = std::min(entrant.box.min_x, p.x),
            entrant.box.max_x = std::max(entrant.box.max_x, p.x);
            entrant.box.min_y = std::min(entrant.box.min_y, p.y),
            entrant.box.max_y = std::max(entrant.box.max_y, p.y);
        }
        entrants.corners.insert(entrants.corners.end(), ring.begin(), ring.end());
    }
}

/// The faces' planes relative to the pixel; needed only where faces overlap.
void VisibleAreas::Working::measure_depths(std::span<const FaceView> faces) {
    for (Entrant& entrant : entrants.faces) {
        entrant.plane = clip::local_plane(pixel, faces[entrant.position].depth);
        measure_depth(entrant);
    }
}

/// An order that depends on the faces alone and not on their places in the list.
bool VisibleAreas::Working::before(const Entrant& p, const Entrant& q) const {
    if (p.w_max != q.w_max) return p.w_max > q.w_max;
    if (p.id != q.id) return p.id < q.id;
    const auto plane = [](const Entrant& e) {
        return std::tuple(e.plane.image.a, e.plane.image.b, e.plane.image.c);
    };
    if (plane(p) != plane(q)) return plane(p) < plane(q);
    const std::span<const Point> a = entrants.ring(p), b = entrants.ring(q);
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](Point u, Point v) {
        return std::pair(u.x, u.y) < std::pair(v.x, v.y);
    });
}

void VisibleAreas::Working::put_in_order() {
    if (nearness == Nearness::ByDepth)
        std::sort(entrants.faces.begin(), entrants.faces.end(),
                  [this](const Entrant& p, const Entrant& q) { return before(p, q); });
}

void VisibleAreas::Working::divide(Nearness by) {
    partition.begin(pixel, entrants, by);
    for (std::uint32_t who = 0; who < entrants.faces.size(); ++who) {
        const Entrant& face = entrants.faces[who];  // in ByDepth, those after it are no nearer
        if (partition.hides_all_below(face.w_max + face.w_error)) break;
        partition.insert(who);
    }
    divided = true;
}

PixelCoverage VisibleAreas::Working::split_pixel(std::span<const FaceView> faces) {
    divided = false;
    // With many faces some overlap as a rule, and comparing all pairs would cost more than it saves.
    constexpr std::size_t kFewFaces = 8;
    if (entrants.faces.size() <= kFewFaces && clip::pairwise_apart(entrants)) return split_faces_apart();
    if (nearness == Nearness::ByDepth) {
        measure_depths(faces);
        put_in_order();
    }
    divide(nearness);
    measures.assign(entrants.faces.size(), {});
    Measure free;
    for (std::size_t i = 0; i < partition.size(); ++i)
        (partition.label(i) == Partition::kFree ? free : measures[partition.label(i)]).add(partition.ring(i));
    return coverage(free);
}

/// Each face shows all of itself; the background is what remains of 1.
PixelCoverage VisibleAreas::Working::split_faces_apart() {
    parts.clear();
    CarefulSum rest;
    rest.add(1);
    for (const Entrant& face : entrants.faces) {
        Measure measure;
        measure.add(entrants.ring(face));
        add_part(face, measure);
        rest.add(-measure.area.value());
    }
    // Faces that fill the pixel leave at most what the rounding of their corners and areas makes: about one
    // rounding for each. Less than that is nothing.
    const double nothing = kHalfUlp * static_cast<double>(2 + entrants.faces.size());
    const double background = rest.value();
    return {parts, background > nothing ? std::min(background, 1.0) : 0};
}

PixelCoverage VisibleAreas::Working::traverse_pixel() {
    rings.clear();
    ring_owner.clear();
    measures.assign(entrants.faces.size(), {});
    const auto keep = [this](const SignedRings& visible, std::uint32_t owner, Measure& measure) {
        for (std::size_t i = 0; i < visible.size(); ++i) {
            measure.add(visible.ring(i), visible.sign(i));
            rings.add(visible.ring(i), visible.sign(i));
            ring_owner.push_back(owner);
        }
    };
    for (std::uint32_t who = 0; who < entrants.faces.size(); ++who)
        keep(traversal.visible(pixel, entrants, who, nearness, observer), who, measures[who]);
    Measure free;
    keep(traversal.background(entrants, observer), Partition::kFree, free);
    return coverage(free);
}

/// Areas as the paper's clipper gives them, wrong ones too, but for what PixelCoverage cannot say: those that
/// are not above 0 are left out.
PixelCoverage VisibleAreas::Working::publish_pixel() {
    if (nearness == Nearness::ByDepth) {  // step (4): one list for the pixel, from nearest to farthest
        const auto middle_w = [this](const Entrant& e) {
            double w = 0;
            for (const Point p : entrants.ring(e)) w += e.plane.a * p.x + e.plane.b * p.y;
            return w / static_cast<double>(e.size) + e.plane.c.hi;
        };
        std::stable_sort(entrants.faces.begin(), entrants.faces.end(),
                         [&](const Entrant& p, const Entrant& q) { return middle_w(p) > middle_w(q); });
    }
    std::vector<Ring> polygons;
    for (const Entrant& e : entrants.faces) {
        const std::span<const Point> ring = entrants.ring(e);
        polygons.emplace_back(ring.begin(), ring.end());
    }
    polygons.emplace_back(std::begin(kPixelRing), std::end(kPixelRing));  // the background, farthest
    const std::vector<double> areas = published.visible_areas(polygons);
    measures.assign(entrants.faces.size(), {});
    Measure free;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        Measure& measure = i < measures.size() ? measures[i] : free;
        for (const PublishedClipper::Piece& piece : published.pieces_of(i))
            if (piece.ring.size() >= 3) measure.add(piece.ring, piece.sign);
        measure.area = {};
        measure.area.add(areas[i]);
    }
    return coverage(free);
}

void VisibleAreas::Working::add_part(const Entrant& face, const Measure& measure) {
    const double area = std::min(measure.area.value(), 1.0);
    if (!(area > 0)) return;
    parts.push_back({face.position, area,
                     {std::clamp(measure.x.value() / area, face.box.min_x, face.box.max_x),
                      std::clamp(measure.y.value() / area, face.box.min_y, face.box.max_y)}});
}

/// The measures of entrants.faces as parts in the order of the question.
PixelCoverage VisibleAreas::Working::coverage(const Measure& free) {
    parts.clear();
    for (std::size_t i = 0; i < measures.size(); ++i) add_part(entrants.faces[i], measures[i]);
    std::sort(parts.begin(), parts.end(),
              [](const VisiblePart& p, const VisiblePart& q) { return p.face < q.face; });
    return {parts, std::clamp(free.area.value(), 0.0, 1.0)};
}

VisibleAreas::VisibleAreas(Engine engine) : working_(std::make_unique<Working>()) { working_->engine = engine; }
VisibleAreas::~VisibleAreas() = default;
VisibleAreas::VisibleAreas(VisibleAreas&&) noexcept = default;
VisibleAreas& VisibleAreas::operator=(VisibleAreas&&) noexcept = default;

PixelCoverage VisibleAreas::operator()(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    Working& work = *working_;
    work.pixel = pixel;
    work.nearness = nearness;
    work.gather(faces);
    work.enter(faces);
    if (work.engine == Engine::Splitting) return work.split_pixel(faces);
    if (nearness == Nearness::ByDepth) work.measure_depths(faces);
    work.put_in_order();
    switch (work.engine) {
        case Engine::Traversal: return work.traverse_pixel();
        case Engine::Published: return work.publish_pixel();
        case Engine::Splitting: break;
    }
    return work.split_pixel(faces);
}

std::span<const VisiblePiece> VisibleAreas::pieces() {
    Working& work = *working_;
    work.pieces.clear();
    if (work.engine != Engine::Splitting) return work.pieces;
    if (!work.divided) work.divide(Nearness::InOrder);  // faces apart: any order will do
    for (std::size_t i = 0; i < work.partition.size(); ++i) {
        const std::uint32_t label = work.partition.label(i);
        const bool free = label == Partition::kFree;
        work.pieces.push_back(
            {free ? VisiblePiece::kBackground : work.entrants.faces[label].position, work.partition.ring(i)});
    }
    return work.pieces;
}

std::span<const VisibleOutline> VisibleAreas::outlines() {
    Working& work = *working_;
    work.outlines.clear();
    if (work.engine != Engine::Traversal) return work.outlines;
    for (std::size_t i = 0; i < work.rings.size(); ++i) {
        const std::uint32_t owner = work.ring_owner[i];
        const std::uint32_t face =
            owner == Partition::kFree ? VisiblePiece::kBackground : work.entrants.faces[owner].position;
        work.outlines.push_back({face, work.rings.sign(i), work.rings.ring(i)});
    }
    return work.outlines;
}

void VisibleAreas::observe(std::function<void(const ClipStep&)> observer) { working_->observer = std::move(observer); }

ClipStatistics VisibleAreas::statistics() const {
    const PublishedTroubles& troubles = working_->published.troubles();
    return {working_->traversal.folds(), troubles.did_not_close, troubles.odd_intersections};
}

}  // namespace keikan
