// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "crosscheck/compare_pixel.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/model/pixel_case.hpp"

namespace keikan::report {

/// What somebody says about a pixel.
struct NamedClaim {
    std::string by;
    crosscheck::Claim claim;
    std::string failure = {};  ///< instead of an answer
};

/// The answer of an engine, as it is: what breaks its contract is told by the check.
NamedClaim engines_claim(Engine engine, const PixelCase& asked);

/// Why a page shows a pixel in detail.
enum class Reason { Disagrees, Worst, Sample };

/// A pixel with everything that its page needs beyond what can be worked out from it.
struct PixelToShow {
    PixelCase asked;
    std::vector<std::string> objects;  ///< whose face each polygon is; empty: nobody's
    std::vector<FaceId> faces;         ///< their ids in the scene; empty: their positions
    std::vector<NamedClaim> claims;
    Engine engine = Engine::Traversal;  ///< whose clip steps are shown (recorded)
    double error = 0;                   ///< the largest of its areas, as the check found it
    std::vector<Reason> reasons;
    std::string note = {};     ///< e.g. whose worst pixel it is
    std::string command = {};  ///< asks it again
    std::vector<crosscheck::Disagreement> disagreements = {};
};

/// The pixel as a JSON object (docs/inspector.md): the question, the claims, the exact areas "p/q" by
/// rational splitting, every clip step with the contacts of engine and oracle, and what can be seen in the
/// end.
std::string pixel_detail_json(const PixelToShow& pixel);

/// Room for the details of a page, as JSON: packed they take a quarter to a third of it. 1000 x 650 pixels
/// with all their layers then stay below 10 MB.
inline constexpr std::size_t kMostDetailBytes = 24'000'000;

struct PixelDetails {
    std::string json;            ///< an array, in the order given
    std::uint64_t left_out = 0;  ///< pixels for which there was no room: the least important
};

/// The same of all, side by side. Property: the same for any number of threads. Requires: each has a reason.
PixelDetails pixel_details_json(const std::vector<PixelToShow>& pixels);

}  // namespace keikan::report
