// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "keikan/model/face.hpp"
#include "keikan/model/pixel.hpp"

namespace keikan::crosscheck {

/// A place where the product is wrong, or where two that must agree do not. Collected and reported, never
/// thrown.
struct Disagreement {
    enum class Kind {
        Area,        ///< of a face: further from the exact one than the bound
        Background,  ///< likewise
        Sum,         ///< areas and background do not add up to 1
        Form,  ///< the answer breaks its own contract: out of order, outside of (0, 1], a pixel left out
        Attributes,  ///< the picture would shade a face with another face's plane, object or material
        Given,       ///< the answer that a case states is not the exact one
        LeftOut,     ///< a face is seen that the projection left out because it could not be
        Contact,     ///< of the paper's clipper: class, turn or index of a contact is not the exact one
        Rungs,       ///< two rungs of the oracle differ: the mistake is in the oracle
    };
    Kind kind = Kind::Area;
    PixelIndex pixel;
    std::string case_id = {};         ///< of a pixel case; empty in a scene
    std::optional<FaceId> face = {};  ///< whose area it is
    double claimed = 0;               ///< by the product
    double exact = 0;                 ///< rounded once
    double error = 0;                 ///< |claimed - exact|
    double bound = 0;                 ///< what `error` may be
    std::string note = {};            ///< what `claimed` and `exact` cannot say

    friend bool operator==(const Disagreement&, const Disagreement&) = default;
};

/// "area", "background" ... as the summary calls it.
const char* name_of(Disagreement::Kind kind);

/// Whether it says how far a number is off: an area, the background or their sum.
bool is_of_areas(Disagreement::Kind kind);

/// One line for people, without the command that repeats it.
std::string text_of(const Disagreement& disagreement);

}  // namespace keikan::crosscheck
