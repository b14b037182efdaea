// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/case_report.hpp"

#include <algorithm>
#include <utility>

#include "crosscheck/error_bounds.hpp"
#include "report/scene_report.hpp"

namespace keikan::report {

void CaseChoice::add(const PixelCase& pixel_case, const crosscheck::PixelVerdict& verdict) {
    errors_.add(verdict.area_error, crosscheck::area_bound(verdict.faces));
    Kept kept{pixel_case, verdict.area_error, verdict.disagreements, false};
    for (int k = 0; k < crosscheck::kPixelKinds; ++k)
        if ((verdict.kinds >> k & 1) != 0 && samples_[static_cast<std::size_t>(k)] < kSamplesOfKind) {
            ++samples_[static_cast<std::size_t>(k)];
            kept.sample = true;
        }
    const bool disagrees = !verdict.disagreements.empty();
    disagreeing_ += disagrees;
    kept_.emplace(cases_++, std::move(kept));
    if (kept_.size() > 4 * (kWorstShown + kDisagreeingShown)) drop_the_best();
}

/// Keeps what may still be shown.
void CaseChoice::drop_the_best() {
    const auto keep = [&](std::size_t count, bool disagreeing, std::map<std::uint64_t, Kept>& result) {
        std::vector<std::pair<double, std::uint64_t>> ranked;
        for (const auto& [number, kept] : kept_)
            if (!disagreeing || !kept.disagreements.empty()) ranked.emplace_back(-kept.error, number);
        std::ranges::sort(ranked);
        if (ranked.size() > count) ranked.resize(count);
        for (const auto& [error, number] : ranked) result.emplace(number, kept_.at(number));
    };
    std::map<std::uint64_t, Kept> rest;
    for (const auto& [number, kept] : kept_)
        if (kept.sample) rest.emplace(number, kept);
    keep(kWorstShown, false, rest);
    keep(kDisagreeingShown, true, rest);
    kept_.swap(rest);
}

void CaseChoice::fill(Page& page) const {
    page.errors = errors_;
    CaseChoice last = *this;
    last.drop_the_best();
    std::uint64_t shown = 0;
    for (const auto& [number, kept] : last.kept_) {
        PixelToShow show = case_to_show(kept.pixel_case, engine_);
        show.error = kept.error;
        show.disagreements = kept.disagreements;
        shown += !kept.disagreements.empty();
        if (!kept.disagreements.empty()) show.reasons.push_back(Reason::Disagrees);
        show.reasons.push_back(kept.sample ? Reason::Sample : Reason::Worst);
        page.pixels.push_back(std::move(show));
    }
    page.disagreeing_left_out = disagreeing_ - shown;
}

PixelToShow case_to_show(const PixelCase& pixel_case, Engine engine) {
    PixelToShow show;
    show.asked = pixel_case;
    show.engine = engine;
    if (engine != Engine::Traversal) show.claims.push_back(engines_claim(engine, pixel_case));
    show.claims.push_back(engines_claim(Engine::Traversal, pixel_case));
    return show;
}

}  // namespace keikan::report
