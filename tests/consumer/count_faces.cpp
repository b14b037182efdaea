// SPDX-License-Identifier: Apache-2.0
// Reads a scene and builds its faces, as a program of a stranger would.
#include <cstdio>
#include <keikan/scene/scene.hpp>
#include <keikan/support/input_error.hpp>

int main(int count, char** arguments) {
    if (count != 2) return 2;
    try {
        const keikan::Scene scene = keikan::read_scene(arguments[1]);
        const keikan::Geometry geometry = keikan::build_geometry(scene);
        std::printf("%s: %zu objects, %u faces\n", arguments[1], geometry.objects.size(),
                    geometry.first_face.back());
        return geometry.first_face.back() > 0 ? 0 : 1;
    } catch (const keikan::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
