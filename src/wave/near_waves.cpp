// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/near_waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "keikan/support/check.hpp"
#include "near_lanes.hpp"
#include "sine_of_turns.hpp"

namespace keikan {

namespace {

/// Rays of one job, on the stack.
constexpr std::size_t kTogether = 64;

/// A bound costs a root and a division: every so many waves one, to tell long from short.
constexpr std::size_t kWavesOfAPrefix = 8;

/// What a float is rounded by, of its size.
constexpr double kFloatUnit = 0x1p-24;

/// No ray is followed in single precision farther from the place than this [m]: a wave 5 mm long has 2^21
/// turns.
constexpr double kFarthestNear_m = 1e4;

using TraceNear = void (*)(const lanes::NearJob&);

TraceNear near_for_this_processor() {
#ifdef KEIKAN_HAS_AVX2_SOURCE
    if (__builtin_cpu_supports("avx2")) return lanes::trace_near_with_avx2;
#endif
    return lanes::trace_near_with_any_processor;
}

/// Amplitudes of cos n theta, n from 1, of a series that is a polynomial in the cosine.
std::array<double, 5> harmonics_of(const WaveSeries& w) {
    std::array<double, 5> h{};
    h[4] = w.height[5] / 16;
    h[3] = w.height[4] / 8;
    h[2] = (w.height[3] + 20 * h[4]) / 4;
    h[1] = (w.height[2] + 8 * h[3]) / 2;
    h[0] = w.height[1] + 3 * h[2] - 5 * h[4];
    return h;
}

}  // namespace

struct NearWaves::Lists {
    const WaveSurface* waves = nullptr;
    glm::dvec2 place{0, 0};
    std::vector<lanes::NearWave> near;
    std::vector<lanes::NearPrefix> prefixes;
    double reach_m = 0;  ///< how far from the place single precision is good enough; below 0: nowhere
    double rate_error = 0;

    /// Adds the wave; the constant of its series is returned.
    double add(const WaveSeries& w, const std::array<double, 5>& h) {
        const double turns = w.turns_x * place.x + w.turns_y * place.y + w.turns_0;
        // cos 2 theta = 2 c^2 - 1, cos 3 theta = 4 c^3 - 3 c.
        const double height[] = {h[0] - 3 * h[2], 2 * h[1], 4 * h[2]};
        lanes::NearWave wave{static_cast<float>(w.turns_x),
                             static_cast<float>(w.turns_y),
                             static_cast<float>(turns - std::nearbyint(turns)),
                             {},
                             {}};
        for (int n = 0; n < 3; ++n) {
            wave.height[n] = static_cast<float>(height[n]);
            wave.by_theta[n] = static_cast<float>(-(n + 1) * height[n]);
        }
        near.push_back(wave);
        return -h[1];
    }
};

NearWaves::NearWaves() : lists_(std::make_unique<Lists>()) {}
NearWaves::~NearWaves() = default;
NearWaves::NearWaves(NearWaves&&) noexcept = default;
NearWaves& NearWaves::operator=(NearWaves&&) noexcept = default;

void NearWaves::set(const WaveSurface& waves, glm::dvec2 place, double error_m) {
    Lists& l = *lists_;
    error_m_ = error_m;
    l.waves = &waves;
    l.place = place;
    l.near.clear();
    l.prefixes.clear();
    l.reach_m = -1;
    if (!(error_m > kTraceError)) return;
    const std::span<const WaveSeries> series = waves.series();
    double left_out = 0, slopes = 0, curvatures = 0, constants = 0, crests = waves.crest_bound_m();
    double xx = 0, xy = 0, yy = 0;
    // The form may be rounded down, by a share of xx + yy.
    constexpr double kUp = 16 * kFloatUnit;
    const auto prefix = [&] {
        l.prefixes.push_back({static_cast<int>(l.near.size()), static_cast<float>(-constants - crests),
                              static_cast<float>(xx + kUp * (xx + yy)), static_cast<float>(xy),
                              static_cast<float>(yy + kUp * (xx + yy))});
    };
    for (std::size_t i = 0; i < series.size(); ++i) {
        const WaveSeries& w = series[i];
        const std::array<double, 5> h = harmonics_of(w);
        left_out += std::abs(h[3]) + std::abs(h[4]);
        const double kx = kTurn * w.turns_x, ky = kTurn * w.turns_y, both = std::abs(kx) + std::abs(ky);
        slopes += waves.bounds(i).first_m * both;
        curvatures += w.second_m * both * both;
        xx += w.second_m * kx * kx;
        xy += w.second_m * kx * ky;
        yy += w.second_m * ky * ky;
        constants += l.add(w, h);
        crests -= w.crest_m;
        if (l.near.size() % kWavesOfAPrefix == 0 || i + 1 == series.size()) prefix();
    }
    if (series.empty()) prefix();
    if (left_out > error_m / 8) return;
    l.reach_m = std::min(kFarthestNear_m, (error_m / 8 / kFloatUnit - 128 * waves.crest_bound_m()) /
                                              (16 * std::max(slopes, 1e-9)));
    l.rate_error = kFloatUnit * (16 * l.reach_m * curvatures + 128 * slopes);
}

void NearWaves::trace(std::span<const WaveRay> rays, std::span<std::optional<WaveMeeting>> meetings) {
    KEIKAN_CHECK(rays.size() == meetings.size(), rays.size() << " rays, " << meetings.size() << " meetings");
    static const TraceNear run_lanes = near_for_this_processor();
    const Lists& l = *lists_;
    const double crest = l.waves == nullptr ? 0 : l.waves->crest_bound_m();
    std::array<lanes::NearRay, kTogether> near;
    std::array<lanes::NearHit, kTogether> hits;
    std::array<double, kTogether> begins;
    std::array<std::size_t, kTogether> place_of;
    std::size_t count = 0;
    const auto trace_them = [&] {
        run_lanes({l.near.data(), l.prefixes.data(), static_cast<int>(l.prefixes.size()),
                   static_cast<float>(error_m_), static_cast<float>(l.rate_error), near.data(), count,
                   hits.data()});
        for (std::size_t i = 0; i < count; ++i)
            if (hits[i].met)
                meetings[place_of[i]] = WaveMeeting{
                    std::min(begins[i] + static_cast<double>(hits[i].t), rays[place_of[i]].t_max),
                    {static_cast<double>(hits[i].slope[0]), static_cast<double>(hits[i].slope[1])},
                    hits[i].steps};
        count = 0;
    };
    std::array<WaveRay, kTogether> far;
    std::array<std::optional<WaveMeeting>, kTogether> far_meetings;
    std::array<std::size_t, kTogether> far_place_of;
    std::size_t far_count = 0;
    const auto trace_far = [&] {
        trace_waves(*l.waves, std::span(far).first(far_count), std::span(far_meetings).first(far_count));
        for (std::size_t i = 0; i < far_count; ++i) meetings[far_place_of[i]] = far_meetings[i];
        far_count = 0;
    };
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const WaveRay& ray = rays[i];
        meetings[i].reset();
        // From where it comes below the crests.
        const double above = ray.origin.z - crest;
        double begin = 0;
        if (above > 0) {
            if (!(ray.direction.z < 0)) continue;
            begin = above / -ray.direction.z;
        }
        if (!(begin <= ray.t_max)) continue;
        const double x = ray.origin.x + begin * ray.direction.x - l.place.x,
                     y = ray.origin.y + begin * ray.direction.y - l.place.y;
        // No farther than to where it has left the troughs behind.
        double way = ray.t_max - begin;
        if (ray.direction.z < 0)
            way =
                std::min(way, (ray.origin.z + begin * ray.direction.z + crest + error_m_) / -ray.direction.z);
        const double x_end = x + way * ray.direction.x, y_end = y + way * ray.direction.y;
        const double farthest = std::max({std::abs(x), std::abs(y), std::abs(x_end), std::abs(y_end)});
        if (!(farthest <= l.reach_m)) {
            // Where a meeting in single precision is its start, it is not to be met at once.
            far[far_count] = ray;
            if (error_m_ > kTraceError) far[far_count].origin.z += error_m_ / 2;
            far_place_of[far_count] = i;
            if (++far_count == kTogether) trace_far();
            continue;
        }
        const auto in_float = [](double v) { return static_cast<float>(v); };
        near[count] = {{in_float(x), in_float(y), in_float(ray.origin.z + begin * ray.direction.z)},
                       {in_float(ray.direction.x), in_float(ray.direction.y), in_float(ray.direction.z)},
                       in_float(way)};
        begins[count] = begin;
        place_of[count] = i;
        if (++count == kTogether) trace_them();
    }
    if (count > 0) trace_them();
    if (far_count > 0) trace_far();
}

}  // namespace keikan
