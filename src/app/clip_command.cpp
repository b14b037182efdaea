// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

#include "commands.hpp"
#include "contact_names.hpp"
#include "keikan/cases/convex_ring.hpp"
#include "keikan/cases/wkt.hpp"
#include "keikan/clip/orient2d.hpp"
#include "keikan/clip/published_clipper.hpp"
#include "keikan/clip/ring_difference.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

struct ClipCommand {
    std::string subject, clip, engine = "traversal";
};

/// What is printed: the difference, its pieces turning from +x towards +y.
struct Difference {
    std::vector<Contact> intersections;  ///< indices into the rings as given
    SignedRings pieces;
};

bool edges_cross(Point a, Point b, Point c, Point d) {
    const auto opposite = [](Sign s, Sign t) { return static_cast<int>(s) * static_cast<int>(t) < 0; };
    return opposite(orient2d(a, b, c), orient2d(a, b, d)) && opposite(orient2d(c, d, a), orient2d(c, d, b));
}

Ring subject_ring(const std::string& text) {
    Ring ring = ring_from_wkt(text, "--subject");
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t j = i + 2; j < ring.size(); ++j)
            if (edges_cross(ring[i], ring[i + 1], ring[j], ring[(j + 1) % ring.size()]))
                throw InputError("--subject", fmt::format("edges {} and {}", i, j), "cross each other");
    return ring;
}

/// The clipper with the vertices at which it does not turn left out, turning from +x towards +y, and the
/// place of each vertex in the ring as given.
struct Clipper {
    Ring ring;
    std::vector<std::uint32_t> given;
    bool reversed = false;
};

Clipper clipper_ring(const std::string& text) {
    const Ring ring = ring_from_wkt(text, "--clip");
    if (!is_convex_ring(ring)) throw InputError("--clip", "", "is not convex");
    Clipper clipper;
    for (std::size_t j = 0; j < ring.size(); ++j) {
        const Sign turn =
            orient2d(ring[(j + ring.size() - 1) % ring.size()], ring[j], ring[(j + 1) % ring.size()]);
        if (turn == Sign::Zero) continue;
        clipper.reversed = turn == Sign::Negative;
        clipper.ring.push_back(ring[j]);
        clipper.given.push_back(static_cast<std::uint32_t>(j));
    }
    if (clipper.reversed) {
        std::reverse(clipper.ring.begin(), clipper.ring.end());
        std::reverse(clipper.given.begin(), clipper.given.end());
    }
    return clipper;
}

/// Clipper vertex or edge `index` in the ring as given: an edge that was reversed starts at its other end.
std::uint32_t given_index(const Clipper& clipper, const Contact& contact) {
    const bool on_edge =
        contact.kind == ContactClass::EdgeEdge || contact.kind == ContactClass::SubjectVertex;
    const std::size_t start =
        on_edge && clipper.reversed ? (contact.clip + 1) % clipper.ring.size() : contact.clip;
    return clipper.given[start];
}

Ring positively_turning(Ring ring) {
    if (twice_signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
    return ring;
}

Difference by_traversal(const Ring& subject, const Clipper& clipper) {
    Difference result;
    IntersectionClassifier classify;
    for (const Contact& contact : classify(subject, clipper.ring))
        if (contact.turn != Turn::Touch) result.intersections.push_back(contact);
    RingDifference difference(IntersectionClassifier::Lattice::Doubles);
    difference(positively_turning(subject), 1, clipper.ring, result.pieces);
    return result;
}

/// The paper's order: intersections of the ring as it turns clockwise on the screen; odd ones enter.
Difference as_published(const Ring& subject, const Clipper& clipper) {
    Difference result;
    PublishedClipper published;
    const Ring ring = positively_turning(subject);
    const bool reversed = ring != subject;
    const std::vector<Contact> found = published.intersections(ring, clipper.ring);
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::size_t x = 0; x < found.size(); ++x) {
        Contact contact = found[x];
        contact.turn = (x % 2 == 0) != reversed ? Turn::Enter : Turn::Leave;
        const bool on_edge =
            contact.kind == ContactClass::EdgeEdge || contact.kind == ContactClass::ClipVertex;
        if (reversed) contact.subject = (2 * n - 1 - contact.subject - (on_edge ? 1 : 0)) % n;
        result.intersections.push_back(contact);
    }
    if (reversed) std::reverse(result.intersections.begin(), result.intersections.end());
    const Ring polygons[] = {clipper.ring, ring};
    published.visible_areas(polygons);
    for (const PublishedClipper::Piece& piece : published.pieces_of(1)) {
        if (piece.ring.empty()) continue;
        result.pieces.add(piece.ring, piece.sign);
        if (piece.to_subtract != 0) result.pieces.add(clipper.ring, -piece.sign);
    }
    return result;
}

std::string json_of(const Difference& difference, const Clipper& clipper) {
    std::string text = "{\"intersections\": [";
    const auto out = std::back_inserter(text);
    const char* comma = "";
    for (const Contact& c : difference.intersections) {
        fmt::format_to(out,
                       "{}{{\"class\": \"{}\", \"point\": [{:.17g}, {:.17g}], \"subject\": {}, \"clip\": {}, "
                       "\"turn\": \"{}\"}}",
                       comma, name_of(c.kind), c.point.x, c.point.y, c.subject, given_index(clipper, c),
                       name_of(c.turn));
        comma = ", ";
    }
    text += "], \"pieces\": [";
    double area = 0;
    comma = "";
    for (std::size_t i = 0; i < difference.pieces.size(); ++i) {
        const std::span<const Point> ring = difference.pieces.ring(i);
        fmt::format_to(out, "{}{{\"sign\": {}, \"ring\": [", comma, difference.pieces.sign(i));
        for (std::size_t v = 0; v < ring.size(); ++v)
            fmt::format_to(out, "{}[{:.17g}, {:.17g}]", v == 0 ? "" : ", ", ring[v].x, ring[v].y);
        text += "]}";
        comma = ", ";
        area += difference.pieces.sign(i) * twice_signed_area(ring) / 2;
    }
    fmt::format_to(out, "], \"area\": {:.17g}}}\n", area);
    return text;
}

void clip(const ClipCommand& command) {
    if (command.engine != "traversal" && command.engine != "published")
        throw InputError("--engine " + command.engine, "",
                         "is not an engine for one difference: traversal, published");
    const Ring subject = subject_ring(command.subject);
    const Clipper clipper = clipper_ring(command.clip);
    Difference difference;
    if (subject.size() >= 3 && clipper.ring.size() >= 3)
        difference =
            command.engine == "traversal" ? by_traversal(subject, clipper) : as_published(subject, clipper);
    else if (subject.size() >= 3)
        difference.pieces.add(positively_turning(subject), 1);  // a clipper without area hides nothing
    AtomicFile out("-");
    out.write(json_of(difference, clipper));
    out.finish();
}

}  // namespace

void add_clip_command(CLI::App& app) {
    auto* const sub =
        app.add_subcommand("clip", "One difference: its intersections by class, its pieces, its area");
    const auto command = std::make_shared<ClipCommand>();
    sub->add_option("--subject", command->subject, "WKT polygon; may be concave and touch itself")
        ->required();
    sub->add_option("--clip", command->clip, "WKT polygon, convex")->required();
    sub->add_option("--engine", command->engine, "traversal or published")->capture_default_str();
    sub->callback([command] { clip(*command); });
}

}  // namespace keikan
