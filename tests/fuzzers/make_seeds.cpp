// SPDX-License-Identifier: Apache-2.0
//
// make_seeds FOLDER: what the fuzzers start from, a folder for each, made of data/degenerate and data/scenes.
// Scan files: make_scan_seeds.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "encoded_case.hpp"
#include "keikan/cases/geojson.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/cases/wkt.hpp"

namespace {

using namespace keikan;
namespace fs = std::filesystem;

const fs::path kData = KEIKAN_SOURCE_DIR "/data";
constexpr std::uintmax_t kLongestScene = 32768;

void put(const fs::path& folder, const std::string& name, const std::string& contents) {
    fs::create_directories(folder);
    std::ofstream(folder / name, std::ios::binary) << contents;
}

void seeds_of_cases(const fs::path& folder) {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kData / "degenerate")) {
        if (entry.path().extension() != ".jsonl") continue;
        std::ifstream in(entry.path());
        PixelCaseReader reader(in, entry.path().string());
        while (const auto c = reader.next()) {
            const std::string name = std::to_string(count++);
            put(folder / "engines", name, fuzzers::encoded_case(*c));
            put(folder / "pixel_case", name, pixel_case_line(*c) + "\n");
            put(folder / "wkt", name, wkt_from_case(*c) + "\n");
            put(folder / "geojson", name, geojson_from_case(*c) + "\n");
        }
    }
    put(folder / "wkt", "ring", "POLYGON ((0 0, 0x1p0 0, 1 1e-3, 0 0))");
    put(folder / "wkt", "holes",
        "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0), (1 1, 2 1, 2 2, 1 1)), EMPTY);POLYGON EMPTY");
}

void seeds_of_scenes(const fs::path& folder) {
    fs::create_directories(folder / "scene");
    for (const auto& entry : fs::directory_iterator(kData / "scenes"))
        if (entry.path().extension() == ".json" && entry.file_size() <= kLongestScene)
            fs::copy_file(entry.path(), folder / "scene" / entry.path().filename(),
                          fs::copy_options::overwrite_existing);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("make_seeds FOLDER\n", stderr);
        return 2;
    }
    try {
        const fs::path folder = argv[1];
        fs::create_directories(folder);
        seeds_of_cases(folder);
        seeds_of_scenes(folder);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_seeds: %s\n", error.what());
        return 1;
    }
}
