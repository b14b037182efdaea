// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/model/pixel_case.hpp"
#include "keikan/scan/projected_faces.hpp"

namespace keikan {

/// What the picture asks in one pixel, as a case that can be stored and asked again: the outlines of
/// faces_at(faces, pixel) and their depth planes, with the id "x,y".
PixelCase pixel_question(const ProjectedFaces& faces, PixelIndex pixel);

}  // namespace keikan
