// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/scene/camera.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan {

/// Whether no back face of the object can be seen from the camera: it is a closed solid, or a terrain above
/// which the camera stands.
///
/// A terrain is a height field over a rectangle (terrain.hpp). A sight line that starts above it and ends at
/// the back of a face, below it, passes through its surface on the way, and shows that instead: the
/// rectangle is convex, so the line cannot enter from the side. Sight lines start on the near plane; they all
/// start above the terrain if the square around the eye that holds the near plane's part of the view lies
/// over the rectangle, and every face over that square stays below that part, its plane continued over the
/// whole square. Sufficient, not necessary; an orthographic camera's lines start too far apart to be asked.
bool backs_are_hidden(const Object& object, const Camera& camera);

}  // namespace keikan
