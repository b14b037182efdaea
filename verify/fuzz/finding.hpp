// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "crosscheck/disagreement.hpp"
#include "keikan/model/pixel_case.hpp"

namespace keikan::fuzz {

/// What a finding is a finding of. Shrinking keeps it, so that one mistake does not turn into another.
struct Symptom {
    crosscheck::Disagreement::Kind kind;  ///< Area stands for Background too
    bool gross = false;                   ///< off by more than kGrossError
    friend bool operator==(const Symptom&, const Symptom&) = default;
};

/// Five orders of magnitude above every bound on what roundings add up to (crosscheck/error_bounds.hpp):
/// an area that is off by more was decided wrongly somewhere.
inline constexpr double kGrossError = 1e-9;

/// Of the first disagreement; nothing if there is none.
std::optional<Symptom> symptom_of(std::span<const crosscheck::Disagreement> disagreements);

/// The first disagreement with this symptom, if there is one.
const crosscheck::Disagreement* find_symptom(std::span<const crosscheck::Disagreement> disagreements,
                                             const Symptom& symptom);

/// A pixel case that an engine answers wrongly.
struct Finding {
    PixelCase as_found;
    std::string family;
    std::uint64_t seed = 1;
    std::string engine;
    crosscheck::Disagreement disagreement;  ///< the first one
    Symptom symptom;
    std::optional<PixelCase> shrunk;  ///< with a name made of its content, and its exact areas
    std::string why;                  ///< what is wrong with the shrunk case, in words
};

/// The name of a finding: its family and 64 bits of hash over `smallest` (pixel, polygons, planes) and
/// engine.
std::string name_of_finding(const PixelCase& smallest, const std::string& family, const std::string& engine);

/// The exact areas and background of the case, by rational splitting.
void state_answers(PixelCase& pixel_case);

/// The shrunk case, and the case as found, as a line of a file of pixel cases with two keys more:
/// "why", what is wrong in words, and "found": id and seed of the case as found, family, engine, kind, error,
/// versions.
std::string shrunk_line(const Finding& finding, const std::string& version);
std::string as_found_line(const Finding& finding, const std::string& version);

}  // namespace keikan::fuzz
