// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "fuzz/finding.hpp"
#include "fuzz/finding_store.hpp"
#include "fuzz/shrink_case.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan::fuzz {
namespace {

/// Between two commits; at the speed of the slowest family some tenths of a second.
constexpr std::uint64_t kCasesInABatch = 1024;

using Clock = std::chrono::steady_clock;

CampaignIdentity identity_of(const CampaignOptions& options) {
    CampaignIdentity identity = options.more_identity;
    std::string& families = identity["families"];
    for (const Family family : options.cases.families) families += fmt::format("{} ", name_of(family));
    std::string& engines = identity["engines"];
    for (const Examinee& examinee : options.examinees) engines += examinee.name + " ";
    identity["seed"] = std::to_string(options.cases.seed);
    identity["depth"] = kDepthChoiceNames[static_cast<std::size_t>(options.cases.depth)];
    identity["first"] = std::to_string(options.first);
    identity["shrunk per family"] = std::to_string(options.shrunk_per_family);
    identity["version"] = options.version;
    return identity;
}

class Campaign {
  public:
    explicit Campaign(const CampaignOptions& options) : options_(options) {
        state_.identity = identity_of(options);
        state_.first = options.first;
        state_.summaries.resize(options.examinees.size());
        if (options.folder.empty()) return;
        store_.emplace(options.folder, options.version);
        journal_ = std::make_unique<CampaignJournal>(options.folder);
        take_up(journal_->committed());
        state_.finished = false;
        journal_->begin(state_);
    }

    CampaignState run(const std::function<void(const CampaignState&)>& progress) {
        const auto start = Clock::now();
        const double before = state_.seconds;
        if (progress) progress(state_);
        while (state_.done < options_.count && state_.seconds < options_.seconds) {
            const std::uint64_t to_boundary = kCasesInABatch - state_.done % kCasesInABatch;
            batch(std::min(to_boundary, options_.count - state_.done));
            state_.seconds = before + std::chrono::duration<double>(Clock::now() - start).count();
            commit();
            if (progress) progress(state_);
        }
        state_.finished = true;
        commit();
        return state_;
    }

  private:
    void take_up(std::optional<CampaignState> committed) {
        if (!committed) return;
        const std::string file = journal_->state_file().string();
        if (!options_.resume) {
            if (committed->finished) return;  // its findings stay; a new count begins
            throw InputError(
                file, "",
                "a campaign that has not come to its end: go on with --resume, or take another folder");
        }
        for (const auto& [key, value] : state_.identity)
            if (committed->identity[key] != value)
                throw InputError(file, key,
                                 fmt::format("the campaign to resume has {}, this one {}",
                                             committed->identity[key], value));
        if (committed->summaries.size() != state_.summaries.size())
            throw InputError(file, "summaries", "one for each engine is expected");
        state_ = std::move(*committed);
    }

    void batch(std::uint64_t count) {
        std::vector<PixelCase> cases(count);
        parallel_for(count,
                     [&](std::size_t i) { cases[i] = options_.cases(state_.first + state_.done + i); });
        std::vector<Finding> findings;
        for (std::size_t e = 0; e < options_.examinees.size(); ++e) examine(e, cases, findings);
        state_.findings += findings.size();
        state_.done += count;
        if (!store_) return;
        shrink(findings);
        for (const Finding& finding : findings) {
            found_lines_ += as_found_line(finding, options_.version) + "\n";
            if (finding.shrunk && state_.stored.insert(finding.shrunk->id).second) store_->keep(finding);
        }
    }

    void examine(std::size_t e, std::span<const PixelCase> cases, std::vector<Finding>& findings) {
        const Examinee& examinee = options_.examinees[e];
        state_.summaries[e] +=
            examinee.examine(cases, state_.first + state_.done,
                             [&](const PixelCase& found, const crosscheck::PixelVerdict& verdict) {
                                 Finding finding{.as_found = found,
                                                 .family = found.id.substr(0, found.id.find('/')),
                                                 .seed = options_.cases.seed,
                                                 .engine = examinee.name,
                                                 .disagreement = verdict.disagreements[0],
                                                 .symptom = *symptom_of(verdict.disagreements),
                                                 .shrunk = {},
                                                 .why = {}};
                                 findings.push_back(std::move(finding));
                             });
    }

    /// Which findings are shrunk depends on the cases before them alone.
    void shrink(std::vector<Finding>& findings) {
        std::vector<Finding*> chosen;
        for (Finding& finding : findings) {
            std::uint64_t& shrunk_before = state_.shrunk[finding.engine + " " + finding.family];
            if (shrunk_before == options_.shrunk_per_family) continue;
            ++shrunk_before;
            chosen.push_back(&finding);
        }
        parallel_for(chosen.size(), [&](std::size_t i) { shrink_one(*chosen[i]); });
    }

    void shrink_one(Finding& finding) const {
        const auto examinee = std::ranges::find(options_.examinees, finding.engine, &Examinee::name);
        const auto judge =
            examinee->make_judge(finding.symptom.kind == crosscheck::Disagreement::Kind::Rungs);
        const auto still_fails = [&](const PixelCase& candidate) {
            return find_symptom(judge(candidate).disagreements, finding.symptom) != nullptr;
        };
        // What only the full check sees (a rung of the oracle that was asked there) stays as it is.
        const bool seen = still_fails(finding.as_found);
        PixelCase smallest = seen ? shrunk(finding.as_found, still_fails) : finding.as_found;
        crosscheck::Disagreement last = finding.disagreement;
        if (seen) {
            const crosscheck::PixelVerdict verdict = judge(smallest);
            last = *find_symptom(verdict.disagreements, finding.symptom);
        }
        smallest.id = name_of_finding(smallest, finding.family, finding.engine);
        last.case_id = smallest.id;
        state_answers(smallest);
        finding.why = crosscheck::text_of(last);
        finding.shrunk = std::move(smallest);
    }

    void commit() {
        if (journal_) journal_->commit(state_, found_lines_);
        found_lines_.clear();
    }

    const CampaignOptions& options_;
    CampaignState state_;
    std::string found_lines_;
    std::optional<FindingStore> store_;
    std::unique_ptr<CampaignJournal> journal_;
};

}  // namespace

CampaignState run_campaign(const CampaignOptions& options,
                           const std::function<void(const CampaignState&)>& progress) {
    return Campaign(options).run(progress);
}

crosscheck::CheckSummary summary_of(const CampaignState& state) {
    crosscheck::CheckSummary all;
    for (const crosscheck::CheckSummary& summary : state.summaries) all += summary;
    all.pixels = state.done;
    all.seconds = state.seconds;
    return all;
}

}  // namespace keikan::fuzz
