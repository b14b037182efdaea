// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/pixel_detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "crosscheck/error_bounds.hpp"
#include "keikan/support/parallel.hpp"
#include "oracle/exact_areas.hpp"
#include "report/clip_recording.hpp"

namespace keikan::report {
namespace {

using Json = nlohmann::ordered_json;

/// The points and rings of a pixel, each once; steps name them by number.
class Outlines {
  public:
    std::size_t ring(const Ring& ring) {
        std::vector<std::size_t> indices;
        for (const Point p : ring) indices.push_back(point(p));
        const auto [at, is_new] = ring_index_.try_emplace(indices, ring_index_.size());
        if (is_new) rings_.push_back(std::move(indices));
        return at->second;
    }
    std::size_t point(Point p) {
        const auto [at, is_new] = point_index_.try_emplace({p.x, p.y}, point_index_.size());
        if (is_new) points_.push_back(Json::array({p.x, p.y}));
        return at->second;
    }
    const Json& points() const { return points_; }
    const Json& rings() const { return rings_; }

  private:
    std::map<std::pair<double, double>, std::size_t> point_index_;
    std::map<std::vector<std::size_t>, std::size_t> ring_index_;
    Json points_ = Json::array(), rings_ = Json::array();
};

/// JSON has no infinity, and no number that is none.
Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json face_json(std::uint32_t face) {
    return face == ClipStep::kBackground ? Json(-1) : Json(face);
}

Json question_json(const PixelToShow& pixel) {
    const PixelCase& asked = pixel.asked;
    Json faces = Json::array();
    for (std::size_t i = 0; i < asked.polygons.size(); ++i) {
        Json face = Json::object();
        if (!pixel.objects.empty()) face["object"] = pixel.objects[i];
        if (!pixel.faces.empty()) face["id"] = pixel.faces[i];
        for (const Point p : asked.polygons[i]) face["ring"].push_back(Json::array({p.x, p.y}));
        if (asked.polygons[i].empty()) face["ring"] = Json::array();
        if (asked.depth) {
            const DepthPlane& w = (*asked.depth)[i];
            face["depth"] = Json::array({w.a, w.b, w.c});
        }
        faces.push_back(std::move(face));
    }
    return faces;
}

Json exact_json(const crosscheck::Question& question) {
    try {
        const auto exact =
            oracle::areas_by_rational_splitting(question.pixel, question.faces, question.nearness);
        Json areas = Json::array();
        for (const mpq_class& area : exact.areas) areas.push_back(area.get_str());
        return {{"areas", std::move(areas)}, {"background", exact.background.get_str()}};
    } catch (const std::logic_error& mistake) {
        return {{"failure", mistake.what()}};
    }
}

Json claims_json(const std::vector<NamedClaim>& claims) {
    Json json = Json::array();
    for (const NamedClaim& c : claims) {
        Json claim{{"by", c.by}};
        if (!c.failure.empty()) {
            claim["failure"] = c.failure;
        } else {
            claim["areas"] = Json::array();
            for (const double area : c.claim.areas) claim["areas"].push_back(finite(area));
            claim["background"] = finite(c.claim.background);
        }
        json.push_back(std::move(claim));
    }
    return json;
}

/// [class, turn, subject, clip, point]
Json contacts_json(const std::vector<Contact>& contacts, Outlines& outlines) {
    Json json = Json::array();
    for (const Contact& c : contacts)
        json.push_back(Json::array({static_cast<int>(c.kind), static_cast<int>(c.turn), c.subject, c.clip,
                                    outlines.point(c.point)}));
    return json;
}

/// Their points aside, which are rounded.
bool same_contacts(const std::vector<Contact>& a, const std::vector<Contact>& b) {
    return std::ranges::equal(a, b, [](const Contact& p, const Contact& q) {
        return p.kind == q.kind && p.turn == q.turn && p.subject == q.subject && p.clip == q.clip;
    });
}

Json step_json(const RecordedStep& step, Outlines& outlines) {
    Json json{{"subject_face", face_json(step.subject.face)},
              {"clip_face", face_json(step.clip_face)},
              {"sign", step.subject.sign},
              {"subject", outlines.ring(step.subject.ring)},
              {"clip", outlines.ring(step.clip)},
              {"contacts", contacts_json(step.contacts, outlines)}};
    // What most steps have in common is left out: the oracle agrees, nothing is taken away.
    if (!step.exact)
        json["exact"] = nullptr;
    else if (!same_contacts(step.contacts, *step.exact))
        json["exact"] = contacts_json(*step.exact, outlines);
    if (step.rest.size() != 1 || step.rest[0] != step.subject) {
        json["rest"] = Json::array();
        for (const SignedRing& r : step.rest)
            json["rest"].push_back(Json::array({r.sign, outlines.ring(r.ring)}));
    }
    if (step.remembered) json["remembered"] = outlines.ring(*step.remembered);
    return json;
}

Json disagreements_json(const std::vector<crosscheck::Disagreement>& disagreements) {
    Json json = Json::array();
    for (const crosscheck::Disagreement& d : disagreements) {
        Json one{{"kind", name_of(d.kind)}, {"text", text_of(d)}};
        if (d.face) one["face"] = *d.face;
        json.push_back(std::move(one));
    }
    return json;
}

/// All pixels: in turns the next of those that disagree, of the worst and of the samples, each by falling
/// error.
std::vector<std::size_t> by_importance(const std::vector<PixelToShow>& pixels) {
    std::array<std::vector<std::size_t>, 3> of_reason;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (const Reason reason : pixels[i].reasons)
            of_reason[static_cast<std::size_t>(reason)].push_back(i);
    std::size_t longest = 0;
    for (auto& list : of_reason) {
        std::ranges::stable_sort(list, std::ranges::greater{},
                                 [&](std::size_t i) { return pixels[i].error; });
        longest = std::max(longest, list.size());
    }
    std::vector<std::size_t> order;
    std::vector<char> there(pixels.size(), 0);
    for (std::size_t rank = 0; rank < longest; ++rank)
        for (const auto& list : of_reason)
            if (rank < list.size() && !std::exchange(there[list[rank]], 1)) order.push_back(list[rank]);
    return order;
}

}  // namespace

NamedClaim engines_claim(Engine engine, const PixelCase& asked) {
    constexpr const char* kNames[] = {"splitting", "traversal", "published"};
    VisibleAreas visible_areas(engine);
    const std::vector<FaceView> faces = asked.faces();
    std::vector<crosscheck::Disagreement> faults;
    const PixelCoverage coverage = visible_areas(asked.pixel, faces, asked.nearness());
    return {kNames[static_cast<int>(engine)],
            crosscheck::claim_of(coverage, faces.size(), asked.pixel, faults)};
}

std::string pixel_detail_json(const PixelToShow& pixel) {
    const std::vector<FaceView> faces = pixel.asked.faces();
    const crosscheck::Question question{pixel.asked.pixel, faces, pixel.asked.nearness()};
    const ClipRecording recording = recorded(question, pixel.engine);
    Outlines outlines;
    Json steps = Json::array(), visible = Json::array(), reasons = Json::array();
    for (const RecordedStep& step : recording.steps) steps.push_back(step_json(step, outlines));
    for (const SignedRing& r : recording.visible)
        visible.push_back(Json::array({face_json(r.face), r.sign, outlines.ring(r.ring)}));
    constexpr const char* kReasons[] = {"disagrees", "worst", "sample"};
    for (const Reason reason : pixel.reasons) reasons.push_back(kReasons[static_cast<int>(reason)]);
    Json json{{"id", pixel.asked.id},
              {"pixel", Json::array({pixel.asked.pixel.x, pixel.asked.pixel.y})},
              {"reasons", std::move(reasons)},
              {"error", finite(pixel.error)},
              {"bound", crosscheck::area_bound(faces.size())},
              {"kinds", recording.kinds},
              {"faces", question_json(pixel)},
              {"claims", claims_json(pixel.claims)},
              {"exact", exact_json(question)},
              {"points", outlines.points()},
              {"rings", outlines.rings()},
              {"steps", std::move(steps)},
              {"visible", std::move(visible)},
              {"whole", recording.whole},
              {"disagreements", disagreements_json(pixel.disagreements)}};
    if (!pixel.note.empty()) json["note"] = pixel.note;
    if (!pixel.command.empty()) json["command"] = pixel.command;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

PixelDetails pixel_details_json(const std::vector<PixelToShow>& pixels) {
    std::vector<std::string> each(pixels.size());
    parallel_for(pixels.size(), [&](std::size_t i) { each[i] = pixel_detail_json(pixels[i]); });
    std::vector<char> kept(pixels.size(), 0);
    std::size_t bytes = 0;
    for (const std::size_t i : by_importance(pixels)) {
        if (bytes + each[i].size() > kMostDetailBytes) continue;
        bytes += each[i].size();
        kept[i] = 1;
    }
    PixelDetails details{.json = "[", .left_out = 0};
    for (std::size_t i = 0; i < each.size(); ++i) {
        if (kept[i] == 0)
            ++details.left_out;
        else
            details.json += (details.json.size() == 1 ? "" : ",\n") + each[i];
    }
    details.json += "]";
    return details;
}

}  // namespace keikan::report
