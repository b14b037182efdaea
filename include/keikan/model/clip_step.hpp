// SPDX-License-Identifier: Apache-2.0
#pragma once
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
};

}  // namespace keikan
