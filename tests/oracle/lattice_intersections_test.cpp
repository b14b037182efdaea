// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/lattice_intersections.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "oracle/exact_double.hpp"
#include "oracle/exact_intersections.hpp"

using namespace keikan;
using namespace keikan::oracle;

namespace {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    int whole(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
    }

  private:
    std::mt19937_64 engine_;
};

/// Strictly convex, once round, from +x towards +y: so are any three of the corners.
bool is_clipper(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t j = i + 1; j < ring.size(); ++j)
            for (std::size_t k = j + 1; k < ring.size(); ++k)
                if (orientation(ring[i], ring[j], ring[k]) <= 0) return false;
    return true;
}

/// Points of a side x side grid in [1, 1 + (side - 1) / 4], each moved by up to `most` times 2^-52.
Point grid_point(Dice& dice, int side, int most) {
    const auto coordinate = [&] {
        return 1 + dice.whole(0, side - 1) / 4.0 + dice.whole(-most, most) * 0x1p-52;
    };
    const double x = coordinate();
    return {x, coordinate()};
}

Ring ring_of(Dice& dice, int side, int most, int corners) {
    Ring ring;
    while (static_cast<int>(ring.size()) < corners) {
        const Point p = grid_point(dice, side, most);
        if (ring.empty() ||
            (ring.back() != p && (static_cast<int>(ring.size()) + 1 < corners || ring[0] != p)))
            ring.push_back(p);
    }
    return ring;
}

bool same(std::span<const Contact> quick, std::span<const Contact> exact, double extent) {
    if (quick.size() != exact.size()) return false;
    for (std::size_t i = 0; i < quick.size(); ++i) {
        const Contact &q = quick[i], &e = exact[i];
        if (q.kind != e.kind || q.turn != e.turn || q.subject != e.subject || q.clip != e.clip) return false;
        if (std::hypot(q.point.x - e.point.x, q.point.y - e.point.y) > extent * 0x1p-49) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("lattice_intersections: the contacts are those of CGAL's constructions, on grids and an ulp beside",
          "[oracle][contacts]") {
    LatticeIntersections quick;
    Dice dice(1);
    long contacts = 0, turns = 0, steps = 0;
    while (steps < 30000) {
        const int side = dice.whole(3, 5), most = dice.whole(0, 2);
        const Ring clip = ring_of(dice, side, most, dice.whole(3, 5));
        if (!is_clipper(clip)) continue;
        // Any ring: concave, touching and crossing itself, turning either way.
        const Ring subject = ring_of(dice, side, most, dice.whole(3, 7));
        const auto found = quick(subject, clip);
        REQUIRE(found.has_value());
        REQUIRE(same(*found, exact_intersections(subject, clip), 4));
        ++steps;
        contacts += static_cast<long>(found->size());
        for (const Contact& c : *found) turns += c.turn != Turn::Touch;
    }
    CHECK(contacts > 10000);
    CHECK(turns > 5000);
}

TEST_CASE("lattice_intersections: numbers that do not fit are left to the constructions",
          "[oracle][contacts]") {
    LatticeIntersections quick;
    const Ring clip{{0, 0}, {1, 0}, {0, 1}};
    CHECK(quick(Ring{{0.25, 0.25}, {2, 2}, {0x1p-53, 1}}, clip));
    CHECK_FALSE(quick(Ring{{0.25, 0.25}, {2, 2}, {0x1p-60, 1}}, clip));
    CHECK_FALSE(quick(Ring{{1e-300, 0.25}, {2, 2}, {0, 1}}, clip));
    CHECK(quick(Ring{{1e-300, 0}, {2e-300, 0}, {0, 1e-300}}, Ring{{0, 0}, {1e-300, 0}, {0, 1e-300}}));
}
