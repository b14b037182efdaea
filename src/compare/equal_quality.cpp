// SPDX-License-Identifier: Apache-2.0
#include "equal_quality.hpp"

#include <algorithm>

#include "timed_run.hpp"

namespace keikan::compare {

namespace {

/// Samples up to which whole pictures are made, and the two numbers of them that seconds are extrapolated
/// from.
constexpr int kMostWhole = 64, kFewSamples = 16;

}  // namespace

QualitySearch::QualitySearch(baseline::Method::Kind kind, const Scene& scene, const Geometry& geometry,
                             const Comparison& comparison, const ComparisonOptions& options)
    : kind_(kind), scene_(scene), geometry_(geometry), comparison_(comparison), options_(options) {}

Seconds QualitySearch::extrapolated(int count) {
    const Seconds few = trial(kFewSamples).seconds, many = trial(kMostWhole).seconds;
    const auto line = [&](double at_few, double at_many) {
        const double each = std::max(at_many - at_few, 0.0) / (kMostWhole - kFewSamples);
        return at_many + each * (count - kMostWhole);
    };
    return {line(few.wall, many.wall), line(few.processor, many.processor)};
}

const Trial& QualitySearch::trial(int count) {
    if (const auto found = trials_.find(count); found != trials_.end()) return found->second;
    const baseline::Method method{kind_, count, {}};
    if (options_.tell) options_.tell("trying " + name_of(method));
    baseline::MethodOptions options;
    options.seed = options_.seed;
    Trial result;
    result.count = count;
    result.extrapolated = samples() && count > kMostWhole;
    const Image<std::uint8_t>* const where =
        comparison_.has_conductors ? &comparison_.conductor_pixels : nullptr;
    if (result.extrapolated && where != nullptr) options.only = *where;
    const TimedRun run = timed_run(method, scene_, geometry_, options);
    result.conductors = picture_error(run.picture.image, comparison_.truth, where);
    result.seconds = result.extrapolated ? extrapolated(count) : run.seconds;
    return trials_.emplace(count, result).first->second;
}

EqualQuality QualitySearch::operator()(Goal goal, double rmse) {
    const auto met = [&](const Trial& t) {
        return goal == Goal::KatoRmse ? t.conductors.rmse <= rmse : t.conductors.off_share <= kWrongShare;
    };
    EqualQuality result{kind_, goal, {}, {}, 0};
    int below = 0, step = 1;
    for (; count(step) <= options_.search_to; below = step, step *= 2) {
        result.last = trial(count(step));
        if (met(result.last)) break;
    }
    if (count(step) > options_.search_to) return result;
    while (step - below > 1) {
        const int middle = below + (step - below) / 2;
        (met(trial(count(middle))) ? step : below) = middle;
    }
    result.reached = trial(count(step));
    return result;
}

std::vector<Trial> QualitySearch::trials() const {
    std::vector<Trial> all;
    for (const auto& [count, trial] : trials_) all.push_back(trial);
    return all;
}

}  // namespace keikan::compare
