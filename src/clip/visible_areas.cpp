// SPDX-License-Identifier: Apache-2.0
#include "keikan/clip/visible_areas.hpp"

#include <algorithm>
#include <vector>

#include "entrants.hpp"
#include "keikan/clip/published_clipper.hpp"
#include "measure.hpp"
#include "splitting.hpp"
#include "traversal.hpp"

namespace keikan {
namespace {

using clip::Entrant;
using clip::Measure;

constexpr Point kPixelRing[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

}  // namespace

struct VisibleAreas::Working {
    PixelIndex pixel;
    Nearness nearness = Nearness::InOrder;
    clip::EntrantReader reader;
    clip::Entrants entrants;
    clip::Splitting splitting;
    std::vector<Measure> measures;
    std::vector<VisiblePart> parts;
    Engine engine = Engine::Splitting;
    clip::Traversal traversal;
    clip::Traversal::Observer observer;
    PublishedClipper published;
    std::vector<VisibleOutline> published_outlines;

    PixelCoverage split_pixel(std::span<const FaceView> faces);
    PixelCoverage traverse_pixel();
    PixelCoverage publish_pixel();
    std::span<const VisibleOutline> published_pieces();
    PixelCoverage coverage(double background);
};

PixelCoverage VisibleAreas::Working::split_pixel(std::span<const FaceView> faces) {
    return coverage(splitting.measure(pixel, faces, nearness, entrants, measures));
}

PixelCoverage VisibleAreas::Working::traverse_pixel() {
    return coverage(traversal.measure(pixel, entrants, nearness, observer, measures));
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
    return coverage(free.area.value());
}

std::span<const VisibleOutline> VisibleAreas::Working::published_pieces() {
    published_outlines.clear();
    for (std::size_t i = 0; i <= entrants.faces.size(); ++i) {
        const std::uint32_t face =
            i < entrants.faces.size() ? entrants.faces[i].position : VisiblePiece::kBackground;
        for (const PublishedClipper::Piece& piece : published.pieces_of(i))
            if (piece.ring.size() >= 3) published_outlines.push_back({face, piece.sign, piece.ring});
    }
    return published_outlines;
}

/// The measures of entrants.faces as parts in the order of the question.
PixelCoverage VisibleAreas::Working::coverage(double background) {
    parts.clear();
    bool by_rising_face = true;
    for (std::size_t i = 0; i < measures.size(); ++i) {
        const double area = std::min(measures[i].area.value(), 1.0);
        if (!(area > 0)) continue;
        const Entrant& face = entrants.faces[i];
        const Point centroid{std::clamp(measures[i].x.value() / area, face.box.min_x, face.box.max_x),
                             std::clamp(measures[i].y.value() / area, face.box.min_y, face.box.max_y)};
        by_rising_face = by_rising_face && (parts.empty() || parts.back().face < face.position);
        parts.push_back({face.position, area, centroid});
    }
    if (!by_rising_face)
        std::sort(parts.begin(), parts.end(),
                  [](const VisiblePart& p, const VisiblePart& q) { return p.face < q.face; });
    return {parts, std::clamp(background, 0.0, 1.0)};
}

VisibleAreas::VisibleAreas(Engine engine) : working_(std::make_unique<Working>()) {
    working_->engine = engine;
}
VisibleAreas::~VisibleAreas() = default;
VisibleAreas::VisibleAreas(VisibleAreas&&) noexcept = default;
VisibleAreas& VisibleAreas::operator=(VisibleAreas&&) noexcept = default;

PixelCoverage VisibleAreas::operator()(PixelIndex pixel, std::span<const FaceView> faces, Nearness nearness) {
    Working& work = *working_;
    work.pixel = pixel;
    work.nearness = nearness;
    work.reader.read(pixel, faces, nearness, work.entrants);
    if (work.engine == Engine::Splitting) return work.split_pixel(faces);
    if (nearness == Nearness::ByDepth) {
        clip::measure_depths(pixel, faces, work.entrants);
        clip::put_in_order_of_depth(work.entrants);
    }
    switch (work.engine) {
        case Engine::Traversal:
            return work.traverse_pixel();
        case Engine::Published:
            return work.publish_pixel();
        case Engine::Splitting:
            break;
    }
    return work.split_pixel(faces);
}

std::span<const VisiblePiece> VisibleAreas::pieces() {
    Working& work = *working_;
    if (work.engine != Engine::Splitting) return {};
    return work.splitting.pieces(work.entrants);
}

std::span<const VisibleOutline> VisibleAreas::outlines() {
    Working& work = *working_;
    if (work.engine == Engine::Published) return work.published_pieces();
    if (work.engine != Engine::Traversal) return {};
    return work.traversal.outlines(work.entrants, work.observer);
}

void VisibleAreas::observe(std::function<void(const ClipStep&)> observer) {
    working_->observer = std::move(observer);
    working_->published.observe({});
    if (working_->engine != Engine::Published || !working_->observer) return;
    // The published clipper knows the faces of the pixel by their order, and the background as the last.
    working_->published.observe([work = working_.get()](ClipStep step) {
        const auto position = [&](std::uint32_t i) {
            return i < work->entrants.faces.size() ? work->entrants.faces[i].position : ClipStep::kBackground;
        };
        step.subject_face = position(step.subject_face);
        step.clip_face = position(step.clip_face);
        work->observer(step);
    });
}

ClipStatistics VisibleAreas::statistics() const {
    const PublishedTroubles& troubles = working_->published.troubles();
    return {working_->traversal.folds(), troubles.did_not_close, troubles.odd_intersections};
}

}  // namespace keikan
