// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/contest.hpp"

#include <algorithm>
#include <utility>

#include "keikan/support/parallel.hpp"

namespace keikan::peers {
namespace {

constexpr std::size_t kCasesAtOnce = 2048;

Batch next_batch(const std::function<std::optional<PixelCase>()>& next) {
    std::vector<PixelCase> cases;
    while (cases.size() < kCasesAtOnce) {
        std::optional<PixelCase> pixel_case = next();
        if (!pixel_case) break;
        cases.push_back(*std::move(pixel_case));
    }
    return Batch(std::move(cases));
}

std::vector<Truth> truths_of(const Batch& batch) {
    std::vector<Truth> truths(batch.cases.size());
    parallel_ranges(truths.size(), 16, [&](std::size_t begin, std::size_t end) {
        TruthTeller tell;
        for (std::size_t i = begin; i < end; ++i) truths[i] = tell(batch.cases[i]);
    });
    return truths;
}

void keep_worst(std::optional<Finding>& worst, const Batch& batch, const std::vector<Truth>& truths,
                Round& round, std::vector<Finding>& few) {
    for (std::size_t i = 0; i < round.replies.size(); ++i) {
        Reply& reply = round.replies[i];
        if (reply.outcome == Outcome::NotAsked) continue;
        const double error = reply.outcome == Outcome::Answered ? error_of(reply.answer, truths[i]) : 0;
        const bool wrong = reply.outcome != Outcome::Answered || error > kWrongBy.front();
        if (wrong && (few.size() < Contest::kWorstFew || is_worse(reply, error, few.back()))) {
            if (few.size() == Contest::kWorstFew) few.pop_back();
            const auto place =
                std::ranges::find_if(few, [&](const Finding& f) { return is_worse(reply, error, f); });
            few.insert(place, {batch.cases[i], reply, error});
        }
        if (worst && !is_worse(reply, error, *worst)) continue;
        worst = Finding{batch.cases[i], std::move(reply), error};
    }
}

}  // namespace

Contest contest(const std::function<std::optional<PixelCase>()>& next,
                std::span<const Contestant> contestants, const std::function<void(std::size_t)>& asked) {
    Contest result;
    for (const Contestant& c : contestants) {
        Standing standing;
        standing.name = c.name;
        standing.version = c.version;
        standing.knows_depth = !c.is_library;
        standing.promises = static_cast<bool>(c.promised_error);
        result.standings.push_back(standing);
    }
    result.worst.resize(contestants.size());
    result.worst_few.resize(contestants.size());
    for (Batch batch = next_batch(next); !batch.cases.empty(); batch = next_batch(next)) {
        const std::vector<Truth> truths = truths_of(batch);
        result.pixels += batch.cases.size();
        for (std::size_t i = 0; i < truths.size(); ++i) {
            result.polygons += truths[i].areas.size();
            result.certified += truths[i].by_certificate;
        }
        for (std::size_t c = 0; c < contestants.size(); ++c) {
            Round round = contestants[c].ask(batch);
            add_round(result.standings[c], contestants[c], batch, truths, round);
            keep_worst(result.worst[c], batch, truths, round, result.worst_few[c]);
            if (asked) asked(batch.cases.size());
        }
    }
    return result;
}

}  // namespace keikan::peers
