// SPDX-License-Identifier: GPL-3.0-or-later
#include "crosscheck/check_contacts.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "keikan/clip/classify_intersections.hpp"
#include "oracle/exact_intersections.hpp"

using namespace keikan;
using namespace keikan::crosscheck;

namespace {

const Ring kSubject{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Ring kClip{{2, -1}, {6, 2}, {4, 4}, {2, 3}};  // crosses two sides, shares the corner (4, 4)

}  // namespace

TEST_CASE("check_contacts: the product's contacts are the exact ones", "[crosscheck][contacts]") {
    IntersectionClassifier classify;
    const auto contacts = classify(kSubject, kClip);
    const std::vector<Contact> exact = oracle::exact_intersections(kSubject, kClip);
    CHECK(exact.size() >= 3);
    CHECK_FALSE(contact_mismatch({kSubject, kClip, contacts}, exact));
}

TEST_CASE("check_contacts: every planted mistake in a contact is reported",
          "[crosscheck][contacts][planted]") {
    const std::vector<Contact> exact = oracle::exact_intersections(kSubject, kClip);
    REQUIRE(exact.size() >= 2);
    const auto reported = [&](auto change) {
        std::vector<Contact> doctored = exact;
        change(doctored);
        return contact_mismatch({kSubject, kClip, doctored}, exact).has_value();
    };
    CHECK_FALSE(reported([](auto&) {}));
    CHECK(reported([](auto& c) { c[0].kind = ContactClass::ClipVertex; }));
    CHECK(reported([](auto& c) { c[0].turn = c[0].turn == Turn::Enter ? Turn::Leave : Turn::Enter; }));
    CHECK(reported([](auto& c) { ++c[1].subject; }));
    CHECK(reported([](auto& c) { ++c[1].clip; }));
    CHECK(reported([](auto& c) { c.pop_back(); }));
    CHECK(reported([](auto& c) { std::swap(c[0], c[1]); }));
}

TEST_CASE("check_contacts: counts the contacts of a pixel with two faces through each other",
          "[crosscheck][contacts]") {
    const Ring low{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}},
        high{{0.2, 0}, {0.8, 0}, {0.8, 1}, {0.2, 1}};
    const FaceView faces[] = {{0, low, {1, 0, 0}}, {1, high, {-1, 0, 1}}};  // equal along x = 1/2
    ContactCheck check;
    PixelVerdict verdict;
    check({{0, 0}, faces, Nearness::ByDepth}, verdict);
    CHECK(verdict.contacts.checked > 0);
    CHECK(verdict.contacts.mismatches == 0);
    CHECK(verdict.disagreements.empty());
}
