// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>

#include "peers/standing.hpp"

namespace keikan::peers {

/// The table for people, in Markdown: a line for each contestant. Counts of pixels wrong are given as shares
/// of the pixels asked.
std::string table_in_markdown(std::span<const Standing> standings);

/// The same as a JSON array: counts and shares, with each contestant's families.
std::string table_in_json(std::span<const Standing> standings);

/// The same to look at, an SVG: for each contestant a bar of the share of pixels that it gave up or got
/// wrong, on a logarithmic scale, darker where wrong by more, and a bar of its speed.
std::string table_as_chart(std::span<const Standing> standings);

/// How fast a contestant is compared with the fastest, 0 if it was not timed.
double speed_of_best(const Standing& standing, std::span<const Standing> standings);

}  // namespace keikan::peers
