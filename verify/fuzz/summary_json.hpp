// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <nlohmann/json.hpp>

#include "crosscheck/check_summary.hpp"

namespace keikan::fuzz {

/// A summary as JSON that names it again, every bit of it.
nlohmann::json json_of(const crosscheck::CheckSummary& summary);

/// Errors: nlohmann::json::exception, for what json_of did not write.
crosscheck::CheckSummary summary_of(const nlohmann::json& json);

}  // namespace keikan::fuzz
