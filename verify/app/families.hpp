// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "fuzz/degenerate_families.hpp"

namespace keikan {

/// The families that `--family` names, as often as it names them; "all" stands for every one of them that
/// `belongs`. Throws InputError, with the known names, for any other name.
std::vector<fuzz::Family> families_of(
    const std::vector<std::string>& names, bool (*belongs)(fuzz::Family) = [](fuzz::Family) { return true; });

}  // namespace keikan
