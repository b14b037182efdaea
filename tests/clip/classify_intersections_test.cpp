// SPDX-License-Identifier: Apache-2.0
//
// The numbered properties of include/keikan/clip/classify_intersections.hpp, over all pairs of a small grid.
// That every contact is the exact one is what tests/proof and keikan-verify ask.
#include "keikan/clip/classify_intersections.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <tuple>

#include "grid_polygons.hpp"

using namespace keikan;
using namespace keikan::test;

namespace {

bool at_subject_vertex(const Contact& c) {
    return c.kind == ContactClass::SubjectVertex || c.kind == ContactClass::SharedVertex;
}
bool at_clip_vertex(const Contact& c) {
    return c.kind == ContactClass::ClipVertex || c.kind == ContactClass::SharedVertex;
}

/// Calls check(subject, clip) for all pairs of the 3 x 3 grid, and for subjects of the 4 x 4 grid that are
/// concave or touch and cross themselves.
template <class Check>
void for_all_pairs(Check check) {
    const std::vector<Ring> polygons = grid_polygons(3, true);
    for (const Ring& a : polygons)
        for (const Ring& b : polygons) check(a, b);
    const Ring bent[] = {{{0, 0}, {3, 0}, {1, 1}, {0, 3}},
                         {{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}},
                         {{0, 0}, {2, 2}, {2, 0}, {0, 2}},
                         {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 0}, {1, 1}}};
    for (const Ring& a : bent)
        for (const Ring& b : polygons) check(a, b);
}

std::vector<Contact> contacts_of(const Ring& subject, const Ring& clip) {
    static IntersectionClassifier classify;
    const auto contacts = classify(subject, clip);
    return {contacts.begin(), contacts.end()};
}

/// The contacts without what names them, sorted.
using Nameless = std::tuple<ContactClass, Turn, double, double>;
std::vector<Nameless> nameless(const std::vector<Contact>& contacts) {
    std::vector<Nameless> result;
    for (const Contact& c : contacts) result.push_back({c.kind, c.turn, c.point.x, c.point.y});
    std::ranges::sort(result);
    return result;
}

Turn swapped(Turn turn) {
    return turn == Turn::Enter ? Turn::Leave : turn == Turn::Leave ? Turn::Enter : Turn::Touch;
}

}  // namespace

TEST_CASE("classify_intersections: property 1: contacts come in the order of travel along the subject",
          "[clip][property]") {
    for_all_pairs([](const Ring& a, const Ring& b) {
        const auto contacts = contacts_of(a, b);
        for (std::size_t i = 1; i < contacts.size(); ++i) {
            const Contact &p = contacts[i - 1], &q = contacts[i];
            REQUIRE(p.subject <= q.subject);
            if (p.subject < q.subject) continue;
            REQUIRE_FALSE(at_subject_vertex(q));
            const Point u = a[p.subject];
            const auto square = [&](Point r) {
                return (r.x - u.x) * (r.x - u.x) + (r.y - u.y) * (r.y - u.y);
            };
            REQUIRE(square(p.point) < square(q.point));
        }
    });
}

TEST_CASE("classify_intersections: property 2: enters and leaves alternate", "[clip][property]") {
    for_all_pairs([](const Ring& a, const Ring& b) {
        std::vector<Turn> turns;
        for (const Contact& c : contacts_of(a, b))
            if (c.turn != Turn::Touch) turns.push_back(c.turn);
        REQUIRE(turns.size() % 2 == 0);
        for (std::size_t i = 1; i < turns.size(); ++i) REQUIRE(turns[i] != turns[i - 1]);
    });
}

TEST_CASE("classify_intersections: property 3: reversing the subject swaps enters and leaves",
          "[clip][property]") {
    for_all_pairs([](const Ring& a, const Ring& b) {
        auto forwards = contacts_of(a, b);
        auto backwards = contacts_of(Ring(a.rbegin(), a.rend()), b);
        for (Contact& c : backwards) c.turn = swapped(c.turn);
        REQUIRE(nameless(forwards) == nameless(backwards));
    });
}

TEST_CASE("classify_intersections: property 3: another start vertex of either ring changes only indices",
          "[clip][property]") {
    for_all_pairs([](const Ring& a, const Ring& b) {
        const auto contacts = contacts_of(a, b);
        Ring moved_a = a, moved_b = b;
        std::rotate(moved_a.begin(), moved_a.begin() + 1, moved_a.end());
        std::rotate(moved_b.begin(), moved_b.begin() + 2, moved_b.end());
        auto moved = contacts_of(moved_a, moved_b);
        REQUIRE(nameless(moved) == nameless(contacts));
        for (Contact& c : moved) {
            c.subject = static_cast<std::uint32_t>((c.subject + 1) % a.size());
            c.clip = static_cast<std::uint32_t>((c.clip + 2) % b.size());
            REQUIRE(std::ranges::count(contacts, c) == 1);
        }
    });
}

TEST_CASE("classify_intersections: property 4: a shared run of boundary has contacts at vertices alone",
          "[clip][property]") {
    for_all_pairs([](const Ring& a, const Ring& b) {
        for (const Contact& c : contacts_of(a, b)) {
            if (at_subject_vertex(c)) REQUIRE(c.point == a[c.subject]);
            if (at_clip_vertex(c)) REQUIRE(c.point == b[c.clip]);
            if (c.kind != ContactClass::EdgeEdge) continue;
            const Point u = a[c.subject], v = a[(c.subject + 1) % a.size()];
            const Point p = b[c.clip], q = b[(c.clip + 1) % b.size()];
            REQUIRE((v.x - u.x) * (q.y - p.y) != (v.y - u.y) * (q.x - p.x));  // not parallel
        }
    });
}

TEST_CASE("classify_intersections: property 5: an edge has at most two contacts inside, first in, then out",
          "[clip][property]") {
    for_all_pairs([](const Ring& a, const Ring& b) {
        std::vector<std::vector<Turn>> inside(a.size());
        for (const Contact& c : contacts_of(a, b))
            if (!at_subject_vertex(c)) inside[c.subject].push_back(c.turn);
        for (const std::vector<Turn>& turns : inside) {
            REQUIRE(turns.size() <= 2);
            if (turns.size() == 2) REQUIRE((turns[0] == Turn::Enter && turns[1] == Turn::Leave));
        }
    });
}

TEST_CASE("classify_intersections: property 6: moved or mirrored rings have the same classes and turns",
          "[clip][property]") {
    for_all_pairs([](const Ring& a, const Ring& b) {
        const auto contacts = contacts_of(a, b);
        Ring moved_a = a, moved_b = b;
        for (Ring* const ring : {&moved_a, &moved_b})
            for (Point& p : *ring) p = {p.x + 4096, p.y - 512};
        const auto moved = contacts_of(moved_a, moved_b);
        // The clipper keeps its orientation: mirrored, it is listed backwards.
        Ring mirrored_a = a, mirrored_b(b.rbegin(), b.rend());
        for (Ring* const ring : {&mirrored_a, &mirrored_b})
            for (Point& p : *ring) p.x = -p.x;
        const auto mirrored = contacts_of(mirrored_a, mirrored_b);
        REQUIRE(moved.size() == contacts.size());
        REQUIRE(mirrored.size() == contacts.size());
        const auto m = static_cast<std::uint32_t>(b.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Contact& c = contacts[i];
            const std::uint32_t last =
                at_clip_vertex(c) ? m - 1 : 2 * m - 2;  // vertex j is m-1-j, edge j m-2-j
            REQUIRE(std::tie(moved[i].kind, moved[i].turn, moved[i].subject, moved[i].clip) ==
                    std::tie(c.kind, c.turn, c.subject, c.clip));
            REQUIRE(std::tie(mirrored[i].kind, mirrored[i].turn, mirrored[i].subject) ==
                    std::tie(c.kind, c.turn, c.subject));
            REQUIRE(mirrored[i].clip == (last - c.clip) % m);
        }
    });
}
