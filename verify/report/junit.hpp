// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>
#include <vector>

#include "crosscheck/check_summary.hpp"

namespace keikan::report {

/// A check, as CI systems count them.
struct JunitCase {
    std::string name;
    std::vector<std::string> failures;  ///< a line each; none: it passed
    std::uint64_t failure_count = 0;    ///< of which `failures` are the first
};

/// One case for each kind of disagreement (areas, background, sum, form ...).
std::vector<JunitCase> junit_cases(const crosscheck::CheckSummary& summary);

/// JUnit XML, as Jenkins, GitLab and others read it: one suite. Characters that XML cannot hold become '?'.
std::string junit_xml(const std::string& suite, std::span<const JunitCase> cases, double seconds);

}  // namespace keikan::report
