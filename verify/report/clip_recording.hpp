// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "crosscheck/compare_pixel.hpp"
#include "crosscheck/pixel_kinds.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/model/contact.hpp"

namespace keikan::report {

/// A ring with its sign, of a face (a position in the list, ClipStep::kBackground for none).
struct SignedRing {
    std::uint32_t face = 0;
    int sign = 1;
    Ring ring;
    friend bool operator==(const SignedRing&, const SignedRing&) = default;
};

/// One clip step as the engine took it, and what the oracle says of its contacts.
struct RecordedStep {
    std::uint32_t clip_face = 0;
    SignedRing subject;
    Ring clip;
    std::vector<Contact> contacts;
    std::optional<std::vector<Contact>>
        exact;                       ///< nothing where the rings are none that it can be asked about
    std::vector<SignedRing> rest;    ///< what remains of the subject
    std::optional<Ring> remembered;  ///< Engine::Published: a hole whose area is only noted, to be subtracted
};

/// How an engine came to its areas in one pixel.
struct ClipRecording {
    std::vector<RecordedStep> steps;
    std::vector<SignedRing> visible;   ///< what remains in the end, the background among it
    crosscheck::PixelKinds kinds = 0;  ///< by Engine::Traversal, whatever the engine
    /// Every visible ring is one that a step left over, or no step touched it: the recording is whole.
    bool whole = true;
};

/// Lets the engine clip the pixel again, and writes down its steps. Engine::Splitting has none: its recording
/// is that of Engine::Traversal, which is checked beside it.
///
/// What remains after a step is the answer of the same function that the engine calls, for the same rings.
ClipRecording recorded(const crosscheck::Question& question, Engine engine);

}  // namespace keikan::report
