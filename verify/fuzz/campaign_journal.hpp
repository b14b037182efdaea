// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "crosscheck/check_summary.hpp"

namespace keikan::fuzz {

/// What a campaign is: two with the same identity ask the same pixels of the same engines.
using CampaignIdentity = std::map<std::string, std::string>;

/// How far a campaign has come. All counts are of finished batches alone.
struct CampaignState {
    CampaignIdentity identity;
    std::uint64_t first = 0;                          ///< number of the first case
    std::uint64_t done = 0;                           ///< cases behind us
    bool finished = false;                            ///< the run came to its end
    double seconds = 0;                               ///< of work, over all runs
    std::vector<crosscheck::CheckSummary> summaries;  ///< one for each examinee
    std::uint64_t findings = 0;                       ///< as found, before shrinking
    std::map<std::string, std::uint64_t> shrunk;      ///< how many of each engine and family were shrunk
    std::set<std::string> stored;                     ///< names of shrunk findings
};

/// The memory of a campaign in the folder `campaign` of its findings: state.json, replaced whole after each
/// batch, and found.log, a line for each finding as it was found, of which state.json says how much counts.
/// Whoever is killed between two of these steps leaves the state before the batch, which is then done again:
/// no finding is lost, nothing counts twice. One process at a time.
///
/// Errors: InputError naming the file.
class CampaignJournal {
  public:
    /// Another process at work in the folder is an InputError.
    explicit CampaignJournal(const std::filesystem::path& folder);
    ~CampaignJournal();
    CampaignJournal(const CampaignJournal&) = delete;
    CampaignJournal& operator=(const CampaignJournal&) = delete;

    /// The state that was committed last, if there is one.
    std::optional<CampaignState> committed() const;

    /// What begins now goes on from `state`: lines after the last commit are cut off. A new campaign adds
    /// its lines to those of the ones before it.
    void begin(const CampaignState& state);

    /// `lines` are whole lines, for the findings since the last commit.
    void commit(const CampaignState& state, const std::string& lines);

    std::filesystem::path state_file() const { return folder_ / "state.json"; }

  private:
    std::filesystem::path folder_;
    int lock_ = -1;
    int found_ = -1;
    std::uint64_t found_bytes_ = 0;
};

}  // namespace keikan::fuzz
