// SPDX-License-Identifier: Apache-2.0
#include "../../src/water/light_lanes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "keikan/water/fresnel.hpp"
#include "keikan/water/slopes.hpp"
#include "keikan/wave/counter_random.hpp"
#include "keikan/wave/pixel_sampler.hpp"
#include "keikan/wave/wave_surface.hpp"

using namespace keikan;

namespace {

/// Samples with their lists: in 0 to 6, out 7 to 14.
struct Mirrors {
    static constexpr std::size_t kCount = 1024;
    struct alignas(32) List {
        float v[kCount];
    };
    std::vector<List> lists = std::vector<List>(15);

    lanes::MirrorJob job(const SlopeCovariance& c, const glm::dvec3& sun) {
        const auto in_float = [](double v) { return static_cast<float>(v); };
        float* l[15];
        for (std::size_t i = 0; i < 15; ++i) l[i] = lists[i].v;
        return {kCount,
                l[0],
                l[1],
                l[2],
                l[3],
                l[4],
                l[5],
                l[6],
                in_float(c.xx),
                in_float(c.xy),
                in_float(c.yy),
                1e-6f,
                in_float(sun.x),
                in_float(sun.y),
                in_float(sun.z),
                {l[7], l[8], l[9]},
                l[10],
                l[11],
                {l[12], l[13], l[14]}};
    }
    double at(std::size_t list, std::size_t i) const { return static_cast<double>(lists[list].v[i]); }
};

/// Views from steep to grazing onto waves that face them, Sobol's points as uniform numbers.
Mirrors mirrors_of(const SlopeCovariance&, double elevation) {
    Mirrors m;
    CounterRandom random(31);
    for (std::size_t i = 0; i < Mirrors::kCount; ++i) {
        const double turn = 6 * random.uniform();
        const glm::dvec3 view(std::cos(elevation) * std::cos(turn), std::cos(elevation) * std::sin(turn),
                              std::sin(elevation));
        const double lean = 0.2 * std::sin(elevation) * (2 * random.uniform() - 1);
        const Point u = scrambled_sobol(static_cast<std::uint32_t>(i), 8);
        const double in[] = {lean * view.x, lean * view.y, view.x, view.y, view.z, u.x, u.y};
        for (std::size_t k = 0; k < 7; ++k) m.lists[k].v[i] = static_cast<float>(in[k]);
    }
    return m;
}

}  // namespace

TEST_CASE("light lanes: mirrored and refracted rays are those of SeenSlopes and Fresnel's law",
          "[water][lanes]") {
    SlopeCovariance ripples, sea;
    ripples.add({1, 0}, 2.5e-4);
    ripples.add({0, 1}, 2.5e-4);
    sea.add({0.6, 0.8}, 0.02);
    sea.add({1, 0}, 0.01);
    sea.add({0, 1}, 0.004);
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, -0.5, 0.4));
    for (const SlopeCovariance& rough : {SlopeCovariance{}, ripples, sea})
        for (const double elevation : {1.3, 0.4, 0.1, 0.02, 0.003}) {
            Mirrors m = mirrors_of(rough, elevation);
            lanes::mirror_with_any_processor(m.job(rough, sun));
            double largest_turn = 0, mean_turn = 0, largest_glitter = 0;
            for (std::size_t i = 0; i < Mirrors::kCount; ++i) {
                const glm::dvec3 v(m.at(2, i), m.at(3, i), m.at(4, i));
                const glm::dvec2 z0(m.at(0, i), m.at(1, i));
                const glm::dvec2 z = SeenSlopes(rough, z0, v).at(m.at(5, i), m.at(6, i));
                const glm::dvec3 n = WavePoint{0, z}.normal();
                const double cosine = std::clamp(glm::dot(n, v), 0.0, 1.0);
                const glm::dvec3 mirrored = 2 * glm::dot(n, v) * n - v;
                const glm::dvec3 found(m.at(7, i), m.at(8, i), m.at(9, i));
                const double turn = glm::length(found - mirrored);
                largest_turn = std::max(largest_turn, turn);
                mean_turn += turn / Mirrors::kCount;
                CHECK(m.at(10, i) == Approx(fresnel_reflectance(cosine)).margin(2e-3));
                const glm::dvec3 down =
                    -(1 / kWaterIndex) * v + (cosine / kWaterIndex - refracted_cosine(cosine)) * n;
                CHECK(glm::length(glm::dvec3(m.at(12, i), m.at(13, i), m.at(14, i)) - down) < 2e-3);
                // Glitter.
                SlopeCovariance wide = rough;
                wide.xx += 1e-6;
                wide.yy += 1e-6;
                const glm::dvec3 h = glm::normalize(sun + v);
                const double density =
                    SeenSlopes(wide, z0, v).density_by_projection({-h.x / h.z, -h.y / h.z});
                const double glitter = std::numbers::pi * fresnel_reflectance(glm::dot(h, v)) * density /
                                       (4 * h.z * h.z * h.z * h.z);
                largest_glitter =
                    std::max(largest_glitter, std::abs(m.at(11, i) - glitter) / std::max(1.0, glitter));
            }
            INFO("elevation " << elevation << ", variance " << rough.xx << ": " << largest_turn << " "
                              << mean_turn);
            CHECK(largest_turn < 3e-3);  // in a tail, where single precision has few numbers
            CHECK(mean_turn < 2e-5);
            CHECK(largest_glitter < 2e-2);
        }
}

TEST_CASE("light lanes: the same bits for vectors of any width", "[water][lanes]") {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2")) return;
    SlopeCovariance rough;
    rough.add({0.6, 0.8}, 0.02);
    rough.add({0, 1}, 0.003);
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, -0.5, 0.4));
    for (const double elevation : {1.3, 0.1, 0.003}) {
        Mirrors narrow = mirrors_of(rough, elevation), wide = narrow;
        lanes::mirror_with_any_processor(narrow.job(rough, sun));
        lanes::mirror_with_avx2(wide.job(rough, sun));
        int different = 0;
        for (std::size_t list = 7; list < 15; ++list)
            for (std::size_t i = 0; i < Mirrors::kCount; ++i)
                different += narrow.lists[list].v[i] == wide.lists[list].v[i] ? 0 : 1;
        CHECK(different == 0);
    }
#endif
}
