// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "peers/standing.hpp"

namespace keikan::peers {

/// A pixel that a contestant gets wrong, or fails at.
struct Finding {
    PixelCase pixel_case;
    Reply reply;
    double error = 0;  ///< for Outcome::Answered
};

/// Whether a reply is worse than a finding: a crash before a hang, a hang before an exception, an exception
/// before any wrong answer, a larger error before a smaller one.
bool is_worse(const Reply& reply, double error, const Finding& than);

/// What the contestant says about this one pixel.
Finding asked_about(PixelCase pixel_case, const Contestant& contestant, TruthTeller& truth);

/// Whether `smaller` still shows what `finding` does: the same kind of failure, or an error of at least half
/// of it.
bool shows_the_same(const Finding& smaller, const Finding& finding);

/// A report for the authors of the contestant, in Markdown: what was asked, the polygons as well-known text
/// as they were handed over, each area as answered and as it is, exactly, and the pixel case. `replay` is the
/// command that prints it again.
std::string bug_report(const Finding& finding, const Contestant& contestant, const std::string& replay);

}  // namespace keikan::peers
