// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fuzz/campaign_journal.hpp"
#include "fuzz/case_series.hpp"
#include "fuzz/examinee.hpp"

namespace keikan::fuzz {

struct CampaignOptions {
    CaseSeries cases;
    std::vector<Examinee> examinees;
    std::uint64_t first = 0;  ///< number of the first case
    std::uint64_t count = std::numeric_limits<std::uint64_t>::max();
    double seconds = std::numeric_limits<double>::infinity();  ///< of work, over all runs of the campaign
    std::filesystem::path folder;                              ///< for the findings; empty: they are counted
    bool resume = false;  ///< go on where the campaign in `folder` stopped
    /// Of each engine and family so many findings are shrunk; the others are noted as they were found.
    std::uint64_t shrunk_per_family = 20;
    std::string version;             ///< of the program, for the findings
    CampaignIdentity more_identity;  ///< what else must be the same for a campaign to go on
};

/// Asks the cases of the series of every examinee, batch by batch, until there are `count` or the time is
/// over, and returns how it went; `progress` sees the state at the start and after each batch. Findings are
/// shrunk and stored (FindingStore, CampaignJournal).
///
/// Properties: (1) Everything but `seconds` is the same for any number of threads and wherever the campaign
///             was interrupted, be it by kill -9, and resumed; so are the files, byte for byte.
/// Errors:     InputError: a campaign in the folder that is not to be resumed but has not come to its end,
///             or is another one; a file that cannot be written.
CampaignState run_campaign(const CampaignOptions& options,
                           const std::function<void(const CampaignState&)>& progress = {});

/// All examinees together: errors are the largest, counts are summed, but a pixel counts once.
crosscheck::CheckSummary summary_of(const CampaignState& state);

}  // namespace keikan::fuzz
