// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "commands.hpp"
#include "report/page.hpp"

namespace keikan {

/// A page of this command with what all pages say: the command as it was given, the seed, the version.
report::Page page_of(const std::string& kind, const CommonOptions& common);

}  // namespace keikan
