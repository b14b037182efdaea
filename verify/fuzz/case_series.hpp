// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "fuzz/degenerate_families.hpp"
#include "keikan/model/pixel_case.hpp"

namespace keikan::fuzz {

/// Whether the cases of a series have depth planes.
enum class DepthChoice : std::uint8_t {
    AsMade,  ///< as degenerate_case makes them: all of some families, a quarter of the others
    Always,  ///< random planes where the family gives none
    Never,   ///< none: nearest first, in the order of the polygons
};

inline constexpr std::string_view kDepthChoiceNames[] = {"as-made", "always", "never"};

/// The pixels of a campaign, numbered. Families take turns, so that every stretch of it sees them all.
struct CaseSeries {
    std::vector<Family> families;
    std::uint64_t seed = 1;
    DepthChoice depth = DepthChoice::AsMade;

    /// Case `number`: of family number % families.size(), degenerate_case of index number / families.size().
    /// Where `depth` changes the case, "/always" or "/never" follows its id.
    PixelCase operator()(std::uint64_t number) const;
};

}  // namespace keikan::fuzz
