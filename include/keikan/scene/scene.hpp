// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "keikan/scene/camera.hpp"
#include "keikan/scene/material.hpp"
#include "keikan/scene/mesh.hpp"
#include "keikan/scene/water.hpp"

namespace keikan {

/// A scene as its file states it: everything but the faces, which build_geometry makes. A change of
/// colours, materials or lights needs only this, and no faces.
struct Scene {
    std::filesystem::path file;
    Camera camera;
    Light light;
    Background background;
    Haze haze;
    std::vector<Material> materials;  ///< sorted by name, so that faces can refer to them by position
    /// One for each water object, in their order: how rays draw it; nothing for flat colour.
    std::vector<std::optional<WaterSurface>> water;
    std::shared_ptr<const nlohmann::json> document;  ///< validated; build_geometry reads the objects from it
    /// Equal for two scenes exactly when their faces, camera, size and material names are (64-bit hash of the
    /// geometric part of the document and of the contents of the files that it names).
    std::uint64_t geometry_hash = 0;
};

/// Reads and validates a scene file (docs/scene.md, data/schema/scene.schema.json). Files that it names are
/// relative to its folder.
///
/// Errors: InputError naming the file, the JSON path ("/objects/3/sag_m") and the reason.
Scene read_scene(const std::filesystem::path& file, std::optional<ImageSize> size = std::nullopt);

/// The faces of the scene, levels of detail chosen for its camera.
///
/// Errors: InputError, as read_scene, for what only shows while building (a grid without data, a mesh that
///         cannot be read, a tower that stands off the terrain).
Geometry build_geometry(const Scene& scene);

/// What is in it, as text for people: camera, sun, terrain frame, towers, spans, sags, faces by kind, notes.
std::string describe(const Scene& scene, const Geometry& geometry);

}  // namespace keikan
