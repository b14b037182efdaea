// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "keikan/support/input_error.hpp"
#include "scene_blocks.hpp"

namespace keikan {
namespace {

glm::dvec2 read_spacing(const JsonNode& node) {
    const NumberRange range = positive_up_to(1e6);
    if (node.value().is_number()) return glm::dvec2(node.number(range));
    node.array_size(2, 2);
    return {node.item(0).number(range), node.item(1).number(range)};
}

GridWindow read_window(JsonObject& terrain) {
    constexpr int kMost = 1 << 28;
    GridWindow window;
    if (const auto node = terrain.optional("window")) {
        JsonObject object(*node);
        window.first_column = object.integer_or("first_column", 0, 0, kMost);
        window.first_row = object.integer_or("first_row", 0, 0, kMost);
        window.columns = object.integer_or("columns", 0, 2, kMost);
        window.rows = object.integer_or("rows", 0, 2, kMost);
        object.no_other_keys();
    }
    window.stride = terrain.integer_or("stride", 1, 1, kMost);
    return window;
}

/// The frame beside the grid: mountains.png has mountains.json.
std::optional<GridFrame> read_side_car(TerrainBlock& block) {
    std::filesystem::path side_car = block.grid_file;
    side_car.replace_extension(".json");
    std::error_code error;
    if (!std::filesystem::is_regular_file(side_car, error)) return std::nullopt;
    block.frame_file = side_car;
    const std::string file = side_car.string();
    const nlohmann::json document = parse_json_file(file);
    return read_grid_frame(JsonNode(document, file, ""));
}

}  // namespace

GridFrame read_grid_frame(const JsonNode& node) {
    JsonObject object(node);
    GridFrame frame;
    frame.spacing_m = read_spacing(object.required("spacing_m"));
    if (const auto corner = object.optional("south_west_m")) frame.south_west_m = corner->pair();
    frame.height_scale_m = object.number_or("height_scale_m", 1, positive_up_to(1e4));
    frame.height_offset_m = object.number_or("height_offset_m", 0, between(-1e5, 1e5));
    if (const auto value = object.optional("void_value")) frame.void_value = value->integer(-32768, 65535);
    for (const char* remark : {"description", "crs"}) {
        if (const auto text = object.optional(remark)) text->text();
    }
    object.no_other_keys();
    return frame;
}

std::filesystem::path named_file(const JsonNode& node, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / node.text();
    std::error_code error;
    if (!std::filesystem::exists(file, error)) node.fail(fmt::format("there is no file {}", file.string()));
    if (!std::filesystem::is_regular_file(file, error))
        node.fail(fmt::format("{} is not a file", file.string()));
    return file;
}

TerrainBlock read_terrain_block(const JsonNode& node, const std::filesystem::path& folder,
                                const MaterialNames& materials) {
    JsonObject object(node);
    TerrainBlock block;
    block.path = node.path();
    block.name = object.text_or("name", "terrain");
    block.grid_file = named_file(object.required("grid"), folder);
    if (const auto frame = object.optional("frame")) {
        block.frame = read_grid_frame(*frame);
    } else {
        block.frame = read_side_car(block);
    }
    if (const auto corner = object.optional("south_west_m")) {
        if (!block.frame) corner->fail("needs a frame to move: this grid has none");
        block.frame->south_west_m = corner->pair();
    }
    block.window = read_window(object);
    block.material = materials.index_of(object.required("material"));
    object.no_other_keys();
    return block;
}

HeightGrid read_terrain_grid(const TerrainBlock& block, const std::string& scene_file) {
    const HeightGrid grid = read_height_grid(block.grid_file, block.frame);
    if (block.window == GridWindow{}) return grid;
    try {
        return windowed(grid, block.window);
    } catch (const InputError& error) {
        throw InputError(scene_file, block.path, error.what());
    }
}

}  // namespace keikan
