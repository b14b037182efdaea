// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "keikan/scene/scene.hpp"
#include "keikan/scene/terrain.hpp"
#include "scene_document.hpp"

namespace keikan {
namespace {

constexpr ImageSize kDefaultSize{1000, 650};

/// Heights of the scene's terrain, whose grid is read when the first height is asked for; 0 without one.
TerrainHeight height_on_demand(const std::optional<TerrainBlock>& terrain, const std::string& file) {
    if (!terrain) return [](double, double) { return std::optional<double>(0); };
    return [&terrain, file, grid = std::optional<HeightGrid>()](double x, double y) mutable {
        if (!grid) grid = read_terrain_grid(*terrain, file);
        return height_at(*grid, x, y);
    };
}

/// Files that a .gltf names for its buffers.
void add_gltf_buffers(const std::filesystem::path& gltf, std::vector<std::filesystem::path>& files) {
    const nlohmann::json document = nlohmann::json::parse(file_bytes(gltf.string()), nullptr, false);
    if (!document.is_object() || !document.contains("buffers") || !document["buffers"].is_array()) return;
    for (const auto& buffer : document["buffers"]) {
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
        const auto uri = buffer["uri"].get<std::string>();
        std::error_code error;
        const std::filesystem::path file = gltf.parent_path() / uri;
        if (!uri.starts_with("data:") && std::filesystem::is_regular_file(file, error)) files.push_back(file);
    }
}

}  // namespace

GeometryBlocks read_geometry_blocks(const nlohmann::json& document, const std::string& file,
                                    const std::vector<Material>& materials) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    const MaterialNames names(materials);
    JsonObject root(JsonNode(document, file, ""));
    GeometryBlocks blocks;
    if (const auto node = root.optional("terrain")) blocks.terrain = read_terrain_block(*node, folder, names);
    if (const auto node = root.optional("objects")) blocks.objects = read_objects(*node, folder, names);
    return blocks;
}

std::vector<std::filesystem::path> geometry_files(const GeometryBlocks& blocks) {
    std::vector<std::filesystem::path> files;
    if (blocks.terrain) {
        files.push_back(blocks.terrain->grid_file);
        if (blocks.terrain->frame_file) files.push_back(*blocks.terrain->frame_file);
    }
    for (const ObjectBlock& object : blocks.objects) {
        if (const auto* mesh = std::get_if<MeshBlock>(&object.block)) {
            files.push_back(mesh->file);
            if (mesh->file.extension() == ".gltf") add_gltf_buffers(mesh->file, files);
        }
    }
    return files;
}

Scene read_scene(const std::filesystem::path& path, std::optional<ImageSize> size) {
    const std::string file = path.string();
    Scene scene;
    scene.file = path;
    scene.document = std::make_shared<const nlohmann::json>(parse_json_file(file));
    JsonObject root(JsonNode(*scene.document, file, ""));
    for (const char* remark : {"$schema", "description"}) {
        if (const auto text = root.optional(remark)) text->text();
    }
    if (const auto node = root.optional("materials")) scene.materials = read_materials(*node);
    if (const auto node = root.optional("light")) scene.light = read_light(*node);
    if (const auto node = root.optional("background")) scene.background = read_background(*node);
    if (const auto node = root.optional("haze")) scene.haze = read_haze(*node);
    const GeometryBlocks blocks = read_geometry_blocks(*scene.document, file, scene.materials);
    for (const ObjectBlock& object : blocks.objects)
        if (const auto* water = std::get_if<WaterBlock>(&object.block)) scene.water.push_back(water->surface);
    root.optional("terrain");
    root.optional("objects");

    ImageSize picture = kDefaultSize;
    if (const auto node = root.optional("image")) picture = read_image_size(*node);
    if (size) picture = *size;
    scene.camera = read_camera(root.required("camera"), picture, height_on_demand(blocks.terrain, file));
    root.no_other_keys();
    scene.geometry_hash = geometry_hash(*scene.document, picture, blocks);
    return scene;
}

}  // namespace keikan
