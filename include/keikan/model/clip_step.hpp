// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "keikan/model/contact.hpp"
#include "keikan/model/point.hpp"

namespace keikan {

/// One step of the paper's clipper: a ring of the subject, the convex clipper, and what was found where they
/// meet. For those who check or draw it; a view, valid while it is shown.
struct ClipStep {
    std::span<const Point> subject;
    std::span<const Point> clip;  ///< turns from +x towards +y
    std::span<const Contact> contacts;
    int sign = 1;  ///< of the subject's ring: -1 is a hole
    static constexpr std::uint32_t kBackground = 0xFFFFFFFFu;
    std::uint32_t subject_face = kBackground;  ///< whose ring it is: position in the list of faces
    std::uint32_t clip_face = kBackground;     ///< whose outline clips, or the part of it that is nearer
};

}  // namespace keikan
