// SPDX-License-Identifier: Apache-2.0
#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "degenerate_pixels.hpp"
#include "exact_reference.hpp"
#include "keikan/clip/visible_areas.hpp"

namespace {

using namespace keikan;
using namespace keikan::test;
using Rational = boost::multiprecision::cpp_rational;

double distance(double a, const Rational& b) {
    const Rational difference = Rational(a) - b;
    return std::abs(static_cast<double>(difference));
}

struct Worst {
    double area = 0, sum = 0;
};

// The rational reference takes minutes under a sanitizer: there it is asked for fewer pixels, and for none of
// many corners, of which only the sum of the areas is looked at.
#ifdef KEIKAN_DEBUG_CHECKS
constexpr int kPixelsOfFamily = 1;
constexpr std::size_t kMostCorners = 60;
#else
constexpr int kPixelsOfFamily = 4;
constexpr std::size_t kMostCorners = 1'000'000;
#endif

std::optional<ExactReference<Rational>::Areas> exact_areas(const PixelCase& pixel_case,
                                                           const std::vector<FaceView>& faces) {
    std::size_t corners = 0;
    for (const FaceView& face : faces) corners += face.outline.size();
    if (corners > kMostCorners) return std::nullopt;
    return ExactReference<Rational>::visible_areas(pixel_case.pixel, faces, pixel_case.nearness());
}

/// The errors of one answer.
Worst errors_of(const PixelCoverage& seen, std::size_t faces,
                const std::optional<ExactReference<Rational>::Areas>& truth) {
    std::vector<double> areas(faces);
    double sum = seen.background;
    for (const VisiblePart& part : seen.parts) {
        areas[part.face] = part.area;
        sum += part.area;
    }
    double error = truth ? distance(seen.background, truth->background) : 0;
    for (std::size_t i = 0; truth && i < faces; ++i)
        error = std::max(error, distance(areas[i], truth->areas[i]));
    return {error, std::abs(sum - 1)};
}

/// The engines that promise the bounds, asked the same pixels.
struct BothEngines {
    VisibleAreas splitting{Engine::Splitting}, traversal{Engine::Traversal};

    /// The larger errors of either.
    Worst errors_of(const PixelCase& pixel_case) {
        const std::vector<FaceView> faces = pixel_case.faces();
        const auto truth = exact_areas(pixel_case, faces);
        if (truth) {
            Rational exact_sum = truth->background;
            for (const Rational& area : truth->areas) exact_sum += area;
            REQUIRE(exact_sum == 1);
        }
        Worst worst;
        for (VisibleAreas* const engine : {&splitting, &traversal}) {
            const Worst errors =
                ::errors_of((*engine)(pixel_case.pixel, faces, pixel_case.nearness()), faces.size(), truth);
            worst = {std::max(worst.area, errors.area), std::max(worst.sum, errors.sum)};
        }
        return worst;
    }
};

/// The largest errors over `count` pixels of a family.
Worst worst_of(const Family& family, std::uint64_t seed, int count, bool with_depth) {
    Worst worst;
    BothEngines engines;
    Dice dice(seed);
    for (int k = 0; k < count; ++k) {
        const Worst errors = engines.errors_of(random_pixel(family, dice, with_depth));
        worst.area = std::max(worst.area, errors.area);
        worst.sum = std::max(worst.sum, errors.sum);
    }
    return worst;
}

}  // namespace

TEST_CASE("visible_areas: every area is within its bound of the exact one, in every degenerate family",
          "[clip][fuzz]") {
    // KEIKAN_FUZZ_SEED=n asks other questions.
    const char* const given = std::getenv("KEIKAN_FUZZ_SEED");
    const std::uint64_t seed = given != nullptr ? std::strtoull(given, nullptr, 10) : 1;
    std::cout << "visible_areas fuzz: seed " << seed << "\n";
    for (const Family& family : families()) {
        const bool crowd = family.name == "crowd";
        for (const bool with_depth : {false, true}) {
            const Worst worst = worst_of(family, seed, crowd ? 1 : kPixelsOfFamily, with_depth);
            INFO(family.name << (with_depth ? " with depth" : "") << ", seed " << seed);
            CHECK(worst.area <= kVisibleAreaError);
            CHECK(worst.sum <= kAreaSumError);
        }
    }
}

TEST_CASE("visible_areas: faces of 80 corners, more than one word of bits, are divided as exactly as others",
          "[clip][degenerate]") {
    PixelCase pixel_case;
    for (const Point centre : {Point{0.4, 0.5}, Point{0.6, 0.5}}) {
        Ring ring;
        for (int i = 0; i < 80; ++i) {
            const double angle = i * 2 * 3.14159265358979 / 80;
            ring.push_back({centre.x + 0.35 * std::cos(angle), centre.y + 0.35 * std::sin(angle)});
        }
        pixel_case.polygons.push_back(ring);
    }
    BothEngines engines;
    const auto check = [&] {
        const Worst errors = engines.errors_of(pixel_case);
        CHECK(errors.area <= kVisibleAreaError);
        CHECK(errors.sum <= kAreaSumError);
    };
    check();
    pixel_case.depth = {{1, 0, 0}, {0, 0.1, 0.5}};
    check();
}
