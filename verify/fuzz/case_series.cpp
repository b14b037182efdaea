// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/case_series.hpp"

#include "fuzz/random_numbers.hpp"

namespace keikan::fuzz {
namespace {

/// Keeps these random numbers apart from those of the families.
constexpr std::uint64_t kStreamOfPlanes = 0x706C616E6573;

}  // namespace

PixelCase CaseSeries::operator()(std::uint64_t number) const {
    const Family family = families[number % families.size()];
    const std::uint64_t index = number / families.size();
    PixelCase made = degenerate_case(family, seed, index);
    const bool wanted = depth == DepthChoice::Always;
    if (depth == DepthChoice::AsMade || made.depth.has_value() == wanted) return made;
    made.depth.reset();
    if (wanted) {
        RandomNumbers random(seed, kStreamOfPlanes + static_cast<std::uint64_t>(family), index);
        made.depth.emplace();
        for (std::size_t i = 0; i < made.polygons.size(); ++i) {
            const double a = random.between(-1, 1);
            const double b = random.between(-1, 1);
            made.depth->push_back({a, b, random.between(-1, 1)});
        }
    }
    made.id += '/';
    made.id += kDepthChoiceNames[static_cast<std::size_t>(depth)];
    return made;
}

}  // namespace keikan::fuzz
