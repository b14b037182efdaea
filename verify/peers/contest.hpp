// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "peers/bug_report.hpp"
#include "peers/contestant.hpp"
#include "peers/standing.hpp"

namespace keikan::peers {

struct Contest {
    std::vector<Standing> standings;            ///< parallel to the contestants
    std::vector<std::optional<Finding>> worst;  ///< of each, the pixel that is_worse than its others
    std::vector<std::vector<Finding>>
        worst_few;  ///< of each, up to kWorstFew answered wrongly or not, worst first
    static constexpr std::size_t kWorstFew = 8;
    std::uint64_t pixels = 0;
    std::uint64_t polygons = 0;
    std::uint64_t certified = 0;  ///< pixels whose truth the certified rung told
};

/// Asks everybody about every case that `next` gives, until it gives none, and holds the answers to the exact
/// ones. The contestants take turns, one at a time, so that each has a processor of its own to be timed on.
/// `asked` is told of how many questions have been put.
///
/// Properties: (1) Everything but the times is the same for any number of threads, if nothing hangs.
Contest contest(const std::function<std::optional<PixelCase>()>& next,
                std::span<const Contestant> contestants, const std::function<void(std::size_t)>& asked = {});

}  // namespace keikan::peers
