// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "keikan/scan/projected_faces.hpp"
#include "oracle/exact_areas.hpp"

namespace keikan::truth {

/// The faces of a scene from their world coordinates, projected without rounding: the camera's numbers and
/// the corners' are taken as exactly the doubles that they are, and everything after that is a fraction.
///
/// The same faces as `projected` holds (what it leaves out is behind the camera, outside of the picture, a
/// hidden back, or without area after rounding), with the same rule for a face's plane (Newell's sum of all
/// corners).
class WorldFaces {
  public:
    /// All references must outlive this.
    WorldFaces(const ProjectedFaces& projected, const Geometry& geometry, const Camera& camera)
        : projected_(projected), geometry_(geometry), camera_(camera) {}

    /// The face at a position in the projected faces.
    oracle::RationalFace operator[](std::size_t position) const;

  private:
    const ProjectedFaces& projected_;
    const Geometry& geometry_;
    const Camera& camera_;
};

struct WorldSummary {
    std::uint64_t pixels = 0;  ///< of the picture
    std::uint64_t checked =
        0;  ///< of those in which more than one face may be seen: a sample, the same every time
    double max_difference = 0;  ///< between the coverages by one object, from world coordinates and from the
                                ///< projected doubles, both exact
    PixelIndex at;              ///< where
    std::string object;         ///< which; empty: the background
};

/// What the rounding of the projection does to coverages: in one of `one_in` pixels that are not certainly of
/// one face, the exact coverage by each object from world coordinates against that from the projected
/// doubles.
///
/// Faces are asked about wherever a pixel next to theirs could hold them, so that none is missed that
/// rounding moved over a border.
WorldSummary rounding_of_projection(const ProjectedFaces& projected, const Geometry& geometry,
                                    const Camera& camera, std::uint64_t seed, std::uint64_t one_in);

}  // namespace keikan::truth
