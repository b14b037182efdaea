// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "compare_pixel.hpp"
#include "keikan/model/clip_step.hpp"

namespace keikan::crosscheck {

/// What is wrong with the contacts of one clip step, in words; nothing if class, turn and both indices of
/// every contact are those that the exact oracle finds, in the same order.
std::optional<std::string> contact_mismatch(const ClipStep& step, std::span<const Contact> exact);

/// Clips the faces of pixels by the paper's clipper (Engine::Traversal) and puts every contact of every clip
/// step to oracle::LatticeIntersections, and to oracle::exact_intersections where that does not answer, on
/// every mismatch, and where asked to; both must agree. One object a thread.
class ContactCheck {
  public:
    /// `kinds`: PixelVerdict::kinds is found too, which a page shows; it takes a fifth more time.
    explicit ContactCheck(bool kinds = false);
    ~ContactCheck();
    ContactCheck(ContactCheck&&) noexcept;
    ContactCheck& operator=(ContactCheck&&) noexcept;

    /// Adds what was found to `verdict`: its counts, and a Disagreement for each step that differs. Returns
    /// the areas that came of it, valid until the next call.
    PixelCoverage operator()(const Question& question, PixelVerdict& verdict, bool by_constructions = false);

  private:
    struct Working;
    std::unique_ptr<Working> working_;
};

}  // namespace keikan::crosscheck
