// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/clip_recording.hpp"

#include <algorithm>

#include "keikan/clip/orient2d.hpp"
#include "keikan/clip/published_clipper.hpp"
#include "keikan/clip/ring_difference.hpp"
#include "oracle/exact_intersections.hpp"
#include "oracle/lattice_intersections.hpp"

namespace keikan::report {
namespace {

/// What the oracle requires of a subject.
bool can_be_asked(const Ring& ring) {
    if (ring.size() < 3) return false;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (ring[i] == ring[(i + 1) % ring.size()]) return false;
    return true;
}

std::optional<std::vector<Contact>> exact_contacts(const Ring& subject, const Ring& clip) {
    if (!can_be_asked(subject) || !can_be_asked(clip)) return std::nullopt;
    oracle::LatticeIntersections quick;
    if (const auto found = quick(subject, clip)) return std::vector<Contact>(found->begin(), found->end());
    return oracle::exact_intersections(subject, clip);
}

std::vector<SignedRing> rest_of(const RecordedStep& step) {
    RingDifference difference(IntersectionClassifier::Lattice::Pixel);
    SignedRings rest;
    difference(step.subject.ring, step.subject.sign, step.clip, rest);
    std::vector<SignedRing> result;
    for (std::size_t i = 0; i < rest.size(); ++i)
        result.push_back({step.subject.face, rest.sign(i), {rest.ring(i).begin(), rest.ring(i).end()}});
    return result;
}

bool is_outside(const Ring& clip, Point p) {
    for (std::size_t j = 0; j < clip.size(); ++j)
        if (orient2d(clip[j], clip[(j + 1) % clip.size()], p) == Sign::Negative) return true;
    return false;
}

/// The published clipper numbers its intersections from a vertex outside on: odd ones enter, even ones leave.
void number_turns(RecordedStep& step) {
    const Ring& ring = step.subject.ring;
    const auto outside = std::ranges::find_if(ring, [&](Point p) { return is_outside(step.clip, p); });
    if (outside == ring.end()) return;
    const auto start = static_cast<std::uint32_t>(outside - ring.begin());
    const auto first =
        std::ranges::find_if(step.contacts, [&](const Contact& c) { return c.subject >= start; });
    const auto n = step.contacts.size();
    const auto offset = static_cast<std::size_t>(first - step.contacts.begin());
    for (std::size_t k = 0; k < n; ++k)
        step.contacts[(offset + k) % n].turn = k % 2 == 0 ? Turn::Enter : Turn::Leave;
}

/// Fig. 3 for this one piece.
void add_published_rest(RecordedStep& step) {
    PublishedClipper clipper;
    const Ring polygons[] = {step.clip, step.subject.ring};
    clipper.visible_areas(polygons);
    for (const PublishedClipper::Piece& piece : clipper.pieces_of(1)) {
        if (piece.ring.empty()) continue;
        step.rest.push_back({step.subject.face, piece.sign * step.subject.sign, piece.ring});
        if (piece.to_subtract != 0) step.remembered = step.clip;
    }
}

/// Whether the recording accounts for the ring: no step clipped it, or one left it over.
bool accounted_for(const ClipRecording& recording, const SignedRing& ring) {
    const auto is_of_face = [&](const RecordedStep& s) { return s.subject.face == ring.face; };
    return std::ranges::none_of(recording.steps, is_of_face) ||
           std::ranges::any_of(recording.steps, [&](const RecordedStep& s) {
               return s.subject == ring || std::ranges::count(s.rest, ring) > 0;
           });
}

std::vector<SignedRing> copies(std::span<const VisibleOutline> outlines) {
    std::vector<SignedRing> result;
    for (const VisibleOutline& o : outlines)
        result.push_back({o.face, o.sign, {o.ring.begin(), o.ring.end()}});
    return result;
}

RecordedStep copy_of(const ClipStep& step) {
    RecordedStep copy;
    copy.clip_face = step.clip_face;
    copy.subject = {step.subject_face, step.sign, {step.subject.begin(), step.subject.end()}};
    copy.clip.assign(step.clip.begin(), step.clip.end());
    copy.contacts.assign(step.contacts.begin(), step.contacts.end());
    return copy;
}

}  // namespace

ClipRecording recorded(const crosscheck::Question& question, Engine engine) {
    ClipRecording recording;
    const bool published = engine == Engine::Published;
    VisibleAreas traversal(Engine::Traversal);
    crosscheck::KindsOfPixel kinds;
    traversal.observe([&](const ClipStep& step) {
        kinds.take(step);
        if (!published) recording.steps.push_back(copy_of(step));
    });
    traversal(question.pixel, question.faces, question.nearness);
    recording.kinds = kinds.kinds(traversal.outlines());
    recording.visible = copies(traversal.outlines());
    if (published) {
        VisibleAreas engine_of_paper(Engine::Published);
        engine_of_paper.observe([&](const ClipStep& step) { recording.steps.push_back(copy_of(step)); });
        engine_of_paper(question.pixel, question.faces, question.nearness);
        recording.visible = copies(engine_of_paper.outlines());
    }
    for (RecordedStep& step : recording.steps) {
        step.exact = exact_contacts(step.subject.ring, step.clip);
        if (published) {
            number_turns(step);
            add_published_rest(step);
        } else {
            step.rest = rest_of(step);
        }
    }
    recording.whole = std::ranges::all_of(recording.visible,
                                          [&](const SignedRing& r) { return accounted_for(recording, r); });
    return recording;
}

}  // namespace keikan::report
