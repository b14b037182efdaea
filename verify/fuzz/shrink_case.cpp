// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/shrink_case.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "keikan/cases/convex_ring.hpp"
#include "keikan/clip/convex_hull.hpp"

namespace keikan::fuzz {
namespace {

bool comes_before(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

bool is_negative_zero(double value) {
    return value == 0 && std::signbit(value);
}

/// What shrinking makes smaller, the most important first; last, rings that do not start at their first
/// corner and zeros with a sign.
using Size = std::tuple<std::size_t, bool, std::size_t, bool, int, std::size_t>;

Size size_of(const PixelCase& c) {
    std::size_t corners = 0, oddities = 0;
    int bits = 0;
    for (const Ring& ring : c.polygons) {
        corners += ring.size();
        oddities += !ring.empty() && std::ranges::min_element(ring, comes_before) != ring.begin();
        for (const Point p : ring) {
            bits += bits_of(p.x) + bits_of(p.y);
            oddities += static_cast<std::size_t>(is_negative_zero(p.x)) + is_negative_zero(p.y);
        }
    }
    if (c.depth)
        for (const DepthPlane& w : *c.depth) bits += bits_of(w.a) + bits_of(w.b) + bits_of(w.c);
    return {c.polygons.size(), c.depth.has_value(), corners, c.pixel != PixelIndex{}, bits, oddities};
}

/// `value` with `digits` binary digits behind the point.
double to_digits(double value, int digits) {
    return std::ldexp(std::nearbyint(std::ldexp(value, digits)), -digits) + 0.0;  // -0 + 0 = 0
}

/// Simpler numbers than `value`, the simplest first.
std::vector<double> simpler(double value) {
    std::vector<double> numbers = {0, 1, 0.5, -1, 2};
    for (const int digits : {0, 1, 2, 3, 4, 5, 6, 8, 10, 13, 16, 20, 26, 32, 40, 46, 50})
        if (std::abs(value) < 0x1p52) numbers.push_back(to_digits(value, digits));
    // Far away or close to 0, leading digits count and not those behind the point.
    if (value != 0 && (std::abs(value) >= 4 || std::abs(value) < 0.25))
        for (const int digits : {0, 1, 3, 8, 16, 30})
            numbers.push_back(to_digits(value, digits - std::ilogb(value)));
    std::erase_if(numbers, [&](double n) { return !std::isfinite(n) || bits_of(n) >= bits_of(value); });
    std::ranges::stable_sort(numbers, {}, bits_of);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

class Shrinking {
  public:
    Shrinking(const PixelCase& failing, const std::function<bool(const PixelCase&)>& still_fails,
              std::size_t most_questions)
        : case_(failing), still_fails_(still_fails), questions_left_(most_questions) {
        case_.id.clear();
        case_.areas.reset();
        case_.background.reset();
    }

    PixelCase result() {
        for (bool smaller = true; smaller && questions_left_ > 0;) {
            const Size before = size_of(case_);
            drop_polygons();
            drop_depth();
            move_to_origin();
            round_everything();
            drop_corners();
            round_corners();
            join_corners();
            simplify_planes();
            start_at_first_corner();
            drop_signs_of_zeros();
            smaller = size_of(case_) < before;
        }
        return case_;
    }

  private:
    /// Takes the candidate if it is smaller, valid and still a finding.
    bool take(PixelCase candidate) {
        for (Ring& ring : candidate.polygons)
            if (!is_convex_ring(ring)) clip::replace_by_hull(ring);
        if (questions_left_ == 0 || size_of(candidate) >= size_of(case_)) return false;
        --questions_left_;
        if (!still_fails_(candidate)) return false;
        case_ = std::move(candidate);
        return true;
    }

    static PixelCase without_polygons(const PixelCase& from, std::size_t begin, std::size_t end) {
        PixelCase rest = from;
        const auto erase = [&](auto& list) {
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(begin),
                       list.begin() + static_cast<std::ptrdiff_t>(end));
        };
        erase(rest.polygons);
        if (rest.depth) erase(*rest.depth);
        return rest;
    }

    void drop_polygons() {
        for (std::size_t length = std::bit_floor(case_.polygons.size()); length > 0; length /= 2)
            for (std::size_t i = 0; i + length <= case_.polygons.size();)
                if (!take(without_polygons(case_, i, i + length))) i += length;
    }

    void drop_depth() {
        if (!case_.depth) return;
        PixelCase flat = case_;
        flat.depth.reset();
        if (take(flat)) return;
        // In the order in which they follow each other in the middle of the pixel.
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < case_.polygons.size(); ++i) {
            const DepthPlane& w = (*case_.depth)[i];
            order.emplace_back(-(w.a * (case_.pixel.x + 0.5) + w.b * (case_.pixel.y + 0.5) + w.c), i);
        }
        std::ranges::sort(order);
        for (std::size_t i = 0; i < order.size(); ++i) flat.polygons[i] = case_.polygons[order[i].second];
        take(std::move(flat));
    }

    void move_to_origin() {
        if (case_.pixel == PixelIndex{}) return;
        PixelCase moved = case_;
        moved.pixel = {};
        for (Ring& ring : moved.polygons)
            for (Point& p : ring) p = {p.x - case_.pixel.x, p.y - case_.pixel.y};
        if (moved.depth)
            for (DepthPlane& w : *moved.depth) w.c += w.a * case_.pixel.x + w.b * case_.pixel.y;
        take(std::move(moved));
    }

    /// All coordinates at once: rounding one corner of two that must coincide would part them.
    void round_everything() {
        for (int digits = 0; digits <= 52; ++digits) {
            PixelCase rounded = case_;
            for (Ring& ring : rounded.polygons)
                for (Point& p : ring)
                    if (std::abs(p.x) < 0x1p52 && std::abs(p.y) < 0x1p52)
                        p = {to_digits(p.x, digits), to_digits(p.y, digits)};
            if (take(std::move(rounded))) return;
        }
    }

    void drop_corners() {
        for (std::size_t r = 0; r < case_.polygons.size(); ++r)
            for (std::size_t i = 0; i < case_.polygons[r].size();) {
                PixelCase less = case_;
                less.polygons[r].erase(less.polygons[r].begin() + static_cast<std::ptrdiff_t>(i));
                if (!take(std::move(less))) ++i;
            }
    }

    void round_corners() {
        for (std::size_t r = 0; r < case_.polygons.size(); ++r)
            for (std::size_t i = 0; i < case_.polygons[r].size(); ++i)
                for (double Point::*const coordinate : {&Point::x, &Point::y})
                    round_coordinate(r, i, coordinate);
    }

    void round_coordinate(std::size_t r, std::size_t i, double Point::*coordinate) {
        if (i >= case_.polygons[r].size()) return;  // rounding the other coordinate made it one with another
        const double value = case_.polygons[r][i].*coordinate;
        for (const double number : simpler(value)) {
            // Wherever the same number stands: edges that touch go on touching. Then here alone.
            PixelCase everywhere = case_;
            for (Ring& ring : everywhere.polygons)
                for (Point& p : ring)
                    if (p.*coordinate == value) p.*coordinate = number;
            if (take(std::move(everywhere))) return;
            PixelCase here = case_;
            here.polygons[r][i].*coordinate = number;
            if (take(std::move(here))) return;
        }
    }

    /// Onto another corner: one that has to lie on an edge can seldom be rounded, but it can move to its end.
    void join_corners() {
        for (std::size_t r = 0; r < case_.polygons.size(); ++r)
            for (std::size_t i = 0; i < case_.polygons[r].size(); ++i)
                for (const Point target : corners()) {
                    if (i >= case_.polygons[r].size()) break;
                    PixelCase joined = case_;
                    joined.polygons[r][i] = target;
                    if (take(std::move(joined))) break;
                }
    }

    Ring corners() const {
        Ring all;
        for (const Ring& ring : case_.polygons) all.insert(all.end(), ring.begin(), ring.end());
        std::ranges::sort(all, comes_before);
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    void simplify_planes() {
        for (std::size_t i = 0; case_.depth && i < case_.depth->size(); ++i)
            for (double DepthPlane::*const part : {&DepthPlane::a, &DepthPlane::b, &DepthPlane::c})
                for (const double number : simpler((*case_.depth)[i].*part)) {
                    PixelCase simple = case_;
                    (*simple.depth)[i].*part = number;
                    if (take(std::move(simple))) break;
                }
    }

    /// The same finding with another first corner is to have the same content.
    void start_at_first_corner() {
        for (std::size_t r = 0; r < case_.polygons.size(); ++r) {
            PixelCase turned = case_;
            Ring& ring = turned.polygons[r];
            std::ranges::rotate(ring, std::ranges::min_element(ring, comes_before));
            take(std::move(turned));
        }
    }

    void drop_signs_of_zeros() {
        PixelCase plain = case_;
        for (Ring& ring : plain.polygons)
            for (Point& p : ring) p = {p.x + 0.0, p.y + 0.0};
        take(std::move(plain));
    }

    PixelCase case_;
    const std::function<bool(const PixelCase&)>& still_fails_;
    std::size_t questions_left_;
};

}  // namespace

int bits_of(double value) {
    if (value == 0) return 0;
    int exponent = 0;
    const double fraction = std::frexp(std::abs(value), &exponent);  // value = fraction * 2^exponent
    const auto significand = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    const int significant = 53 - std::countr_zero(significand);
    return significant + std::max(0, -exponent);
}

PixelCase shrunk(const PixelCase& failing, const std::function<bool(const PixelCase&)>& still_fails,
                 std::size_t most_questions) {
    return Shrinking(failing, still_fails, most_questions).result();
}

}  // namespace keikan::fuzz
