// SPDX-License-Identifier: Apache-2.0
//
// Hand-made scenes in front of a camera that is easy to think in: at the origin, looking along +y, one pixel
// for one metre at 10 m distance, image point (0, 0) in the upper left corner.
#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "keikan/scan/scan_scene.hpp"

namespace keikan::small_scenes {

inline Camera camera(ImageSize size = {4, 4}) {
    Camera camera;
    camera.focal_px = 10;
    camera.centre_x = 0;
    camera.centre_y = 0;
    camera.size = size;
    return camera;
}

inline Camera orthographic(ImageSize size = {4, 4}) {
    Camera result = camera(size);
    result.kind = Camera::Kind::Orthographic;
    result.focal_px = 1;
    return result;
}

/// The world point seen at image point (x, y), `depth` metres away.
inline glm::dvec3 at(const Camera& camera, double x, double y, double depth) {
    return camera.kind == Camera::Kind::Perspective
               ? glm::dvec3(x * depth / camera.focal_px, depth, -y * depth / camera.focal_px)
               : glm::dvec3(x / camera.focal_px, depth, -y / camera.focal_px);
}

/// The position of pixel (x, y) among all, row by row.
inline std::size_t at_pixel(const Camera& camera, int x, int y) {
    return static_cast<std::size_t>(y * camera.size.width + x);
}

struct Corner {
    double x, y, depth;
};

/// One face on its own, as a mesh.
inline void add_face(Mesh& mesh, const Camera& camera, const std::vector<Corner>& corners) {
    std::vector<std::uint32_t> indices;
    for (const Corner& c : corners) indices.push_back(mesh.add_position(at(camera, c.x, c.y, c.depth)));
    mesh.add_face(indices, 0);
}

inline Geometry geometry(std::vector<Object> objects) {
    Geometry result;
    result.objects = std::move(objects);
    result.first_face.push_back(0);
    for (const Object& object : result.objects)
        result.first_face.push_back(result.first_face.back() +
                                    static_cast<std::uint32_t>(object.mesh.face_count()));
    return result;
}

inline Geometry geometry(Mesh mesh, ObjectKind kind = ObjectKind::Model) {
    return geometry({Object{"object", kind, std::move(mesh)}});
}

/// A rectangle [left, right] x [top, bottom] of the image, facing the camera.
inline void add_rectangle(Mesh& mesh, const Camera& camera, double left, double top, double right,
                          double bottom, double depth) {
    add_face(mesh, camera,
             {{left, top, depth}, {right, top, depth}, {right, bottom, depth}, {left, bottom, depth}});
}

/// A bumpy sheet of `cells` x `cells` x 2 triangles over [x, x + side]^2 of the image: corners are shared, so
/// that inner edges have a face on either side.
inline Mesh sheet(const Camera& camera, double x, double y, double side, int cells, double depth,
                  std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-0.3, 0.3);
    Mesh mesh;
    const double step = side / cells;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            // One after the other: the order in which arguments are computed is the compiler's.
            const double z = depth * (1 + 0.1 * off(random)), v = y + (j + off(random)) * step;
            mesh.add_position(at(camera, x + (i + off(random)) * step, v, z));
        }
    const auto corner = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const std::uint32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                                d = corner(i, j + 1);
            mesh.add_face(std::vector{a, b, c}, 0);
            mesh.add_face(std::vector{a, c, d}, 0);
        }
    return mesh;
}

/// `count` random triangles and quads, large and tiny, near and far, through each other.
inline Mesh soup(const Camera& camera, int count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Mesh mesh;
    for (int f = 0; f < count; ++f) {
        const double cx = unit(random) * camera.size.width, cy = unit(random) * camera.size.height;
        const double size = unit(random) < 0.5 ? 0.5 : 0.4 * camera.size.width;
        const double depth = 5 + 20 * unit(random);
        const auto corner = [&] {
            return Corner{cx + size * (unit(random) - 0.5), cy + size * (unit(random) - 0.5),
                          depth * (1 + 0.3 * (unit(random) - 0.5))};
        };
        if (f % 3 == 0)
            add_rectangle(mesh, camera, cx, cy, cx + size * unit(random), cy + 0.1 * unit(random), depth);
        else
            add_face(mesh, camera, {corner(), corner(), corner()});
    }
    return mesh;
}

/// What a pixel shows, out of the bands.
struct Shown {
    bool divided = false;
    Division division = Division::ExactAreas;
    std::vector<std::pair<FaceId, double>> weights;  ///< by rising id
    double background = 0;
};

std::vector<ScanBand> scanned(const Geometry& geometry, const Camera& camera,
                              const ScanOptions& options = {});
/// Every pixel, row by row. Fails when one is missing or there twice.
std::vector<Shown> shown(const std::vector<ScanBand>& bands, ImageSize size);

}  // namespace keikan::small_scenes
