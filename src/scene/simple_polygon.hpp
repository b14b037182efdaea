// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keikan {

/// Why an outline is not a simple polygon, in words; nothing if it is one: at least three corners, no corner
/// twice, no side that meets another but in their common corner, and so an area. Corners in the middle of a
/// straight side are fine.
///
/// Exact: the signs of orient2d. Cost: quadratic in the corners.
std::optional<std::string> why_not_simple(std::span<const glm::dvec2> outline);

/// Divides a simple polygon, of either orientation, into triangles by cutting off ears: indices into
/// `outline`, each triangle counter-clockwise.
///
/// Properties: (1) corners - 2 triangles, each with area. (2) They share their edges whole: no corner lies
///             inside another triangle's edge.
/// Requires:   why_not_simple says nothing.
/// Exact:      every choice is the sign of an orient2d.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::dvec2> outline);

}  // namespace keikan
