// SPDX-License-Identifier: GPL-3.0-or-later
#include "families.hpp"

#include <fmt/format.h>

#include "keikan/support/input_error.hpp"

namespace keikan {

std::vector<fuzz::Family> families_of(const std::vector<std::string>& names, bool (*belongs)(fuzz::Family)) {
    std::vector<fuzz::Family> families;
    for (const std::string& name : names) {
        if (const auto family = fuzz::family_of(name)) {
            families.push_back(*family);
            continue;
        }
        std::string known;
        for (std::size_t f = 0; f < fuzz::kFamilyNames.size(); ++f) {
            known += fmt::format(" {}", fuzz::kFamilyNames[f]);
            const auto family = static_cast<fuzz::Family>(f);
            if (name == "all" && belongs(family)) families.push_back(family);
        }
        if (name != "all") throw InputError(fmt::format("--family {}: there are only: all{}", name, known));
    }
    return families;
}

}  // namespace keikan
