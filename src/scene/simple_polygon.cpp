// SPDX-License-Identifier: Apache-2.0
#include "simple_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

#include "keikan/clip/orient2d.hpp"
#include "keikan/support/check.hpp"

namespace keikan {
namespace {

int turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return static_cast<int>(orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}));
}

bool in_box(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool boxes_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
           std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

/// Whether the closed segments ab and cd have a point in common.
bool segments_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    if (!boxes_meet(a, b, c, d)) return false;
    const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) || (cda == 0 && in_box(c, d, a)) ||
           (cdb == 0 && in_box(c, d, b));
}

/// +1 counter-clockwise, -1 clockwise: the turn at the lowest of the leftmost corners that is no flat one.
int orientation(std::span<const glm::dvec2> outline) {
    const auto leftmost = std::min_element(outline.begin(), outline.end(), [](glm::dvec2 p, glm::dvec2 q) {
        return p.x < q.x || (p.x == q.x && p.y < q.y);
    });
    const std::size_t n = outline.size(), i = static_cast<std::size_t>(leftmost - outline.begin());
    return turn(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]);
}

/// The corners that are left, counter-clockwise.
class EarCutter {
  public:
    explicit EarCutter(std::span<const glm::dvec2> outline) : outline_(outline), left_(outline.size()) {
        std::iota(left_.begin(), left_.end(), 0U);
        if (orientation(outline) < 0) std::reverse(left_.begin(), left_.end());
    }

    std::vector<std::array<std::uint32_t, 3>> triangles() {
        std::vector<std::array<std::uint32_t, 3>> cut;
        std::size_t i = 0;
        for (std::size_t tries = 0; left_.size() > 3; ++tries) {
            KEIKAN_CHECK(tries <= left_.size(),
                         "a polygon of " << outline_.size() << " corners without an ear");
            if (is_ear(i)) {
                cut.push_back(corner(i));
                left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
                tries = 0;
            } else {
                ++i;
            }
            i %= left_.size();
        }
        cut.push_back(corner(1));
        return cut;
    }

  private:
    std::array<std::uint32_t, 3> corner(std::size_t i) const {
        const std::size_t n = left_.size();
        return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
    }

    /// The corner turns left and no other corner lies in its triangle or on its border.
    bool is_ear(std::size_t i) const {
        const auto abc = corner(i);
        const glm::dvec2 a = outline_[abc[0]], b = outline_[abc[1]], c = outline_[abc[2]];
        if (turn(a, b, c) <= 0) return false;
        const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t k) {
            const glm::dvec2 p = outline_[k];
            if (k == abc[0] || k == abc[1] || k == abc[2] || !in_box(low, high, p)) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    std::span<const glm::dvec2> outline_;
    std::vector<std::uint32_t> left_;
};

}  // namespace

std::optional<std::string> why_not_simple(std::span<const glm::dvec2> outline) {
    const std::size_t n = outline.size();
    if (n < 3) return "an outline needs three corners";
    const auto side = [&](std::size_t i) { return std::pair(outline[i], outline[(i + 1) % n]); };
    for (std::size_t i = 0; i < n; ++i) {
        const auto [a, b] = side(i);
        if (a == b) return fmt::format("corners {} and {} are the same point", i, (i + 1) % n);
        for (std::size_t j = i + 1; j < n; ++j) {
            const auto [c, d] = side(j);
            const bool next = j == i + 1, before = (j + 1) % n == i;
            // Neighbours share one corner; the far end of either must not lie on the other.
            const bool meet = next     ? (turn(a, b, d) == 0 && (in_box(a, b, d) || in_box(c, d, a)))
                              : before ? (turn(c, d, b) == 0 && (in_box(c, d, b) || in_box(a, b, c)))
                                       : segments_meet(a, b, c, d);
            if (meet) return fmt::format("its sides {} and {} cross or touch", i, j);
        }
    }
    return std::nullopt;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::dvec2> outline) {
    KEIKAN_CHECK(outline.size() >= 3, "an outline needs three corners");
    return EarCutter(outline).triangles();
}

}  // namespace keikan
