// SPDX-License-Identifier: Apache-2.0
#include "visible_stretches.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

using namespace keikan::baseline;

namespace {

/// What a slow look at one place says: the crossed face with the largest w, the smaller number among equals.
std::uint32_t seen_at(const std::vector<Crossed>& crossed, double t) {
    std::uint32_t seen = ~0u;
    double best = 0;
    for (const Crossed& c : crossed) {
        const double w = c.slope * t + c.start;
        if (c.begin <= t && t < c.end && (seen == ~0u || w > best || (w == best && c.face < seen))) {
            seen = c.face;
            best = w;
        }
    }
    return seen;
}

}  // namespace

TEST_CASE("VisibleStretches (2): two faces that pass through each other change places where they meet",
          "[baseline][lines]") {
    VisibleStretches visible;
    const std::vector<Crossed> crossed{{0, 4, 1, 0, 7}, {1, 3, -1, 4, 3}};  // equal at t = 2
    const auto seen = visible(crossed, 10);
    REQUIRE(seen.size() == 3);
    CHECK((seen[0].face == 7 && seen[0].begin == 0 && seen[0].end == 1));
    CHECK((seen[1].face == 3 && seen[1].begin == 1 && seen[1].end == 2));
    CHECK((seen[2].face == 7 && seen[2].begin == 2 && seen[2].end == 4));
}

TEST_CASE("VisibleStretches: the same face is seen everywhere as by looking at every face in that place",
          "[baseline][lines]") {
    std::mt19937 random(5);
    VisibleStretches visible;
    int looked = 0, wrong = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<Crossed> crossed;
        const auto faces = static_cast<std::uint32_t>(1 + random() % 12);
        for (std::uint32_t f = 0; f < faces; ++f) {
            // Whole numbers, so that ends, and heights, often coincide.
            const double begin = static_cast<int>(random() % 24) - 4,
                         length = static_cast<double>(1 + random() % 12);
            crossed.push_back({begin, begin + length, static_cast<int>(random() % 5) - 2.0,
                               static_cast<double>(random() % 20), f});
        }
        std::sort(crossed.begin(), crossed.end(),
                  [](const Crossed& a, const Crossed& b) { return a.begin < b.begin; });
        const auto seen = visible(crossed, 20);
        for (std::size_t i = 1; i < seen.size(); ++i)
            wrong += seen[i].begin < seen[i - 1].end ||
                     (seen[i].begin == seen[i - 1].end && seen[i].face == seen[i - 1].face);
        for (double t = 0.013; t < 20; t += 0.1) {
            std::uint32_t by_stretch = ~0u;
            for (const Stretch& s : seen)
                if (s.begin <= t && t < s.end) by_stretch = s.face;
            wrong += by_stretch != seen_at(crossed, t);
            ++looked;
        }
    }
    CHECK(looked == 300 * 200);
    CHECK(wrong == 0);
}
