// SPDX-License-Identifier: Apache-2.0
//
// make_scan_seeds FOLDER: scan files of a small picture, each behind the byte that scan_file_fuzzer asks for.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "keikan/scan/scan_file.hpp"
#include "keikan/scan/scan_scene.hpp"
#include "keikan/scene/scene.hpp"

namespace {

using namespace keikan;
namespace fs = std::filesystem;

void seeds_of_scan_files(const fs::path& folder) {
    const Scene scene = read_scene(KEIKAN_SOURCE_DIR "/data/scenes/hill.json", ImageSize{24, 12});
    const Geometry geometry = build_geometry(scene);
    const ProjectedFaces faces = project_faces(geometry, scene.camera);
    for (const Extraction extraction : {Extraction::Outline, Extraction::Paper}) {
        const fs::path file = folder / "whole.scan";
        ScanFileWriter writer(file, {scene.camera.size, extraction, scene.geometry_hash});
        scan_faces(faces, geometry, scene.camera, {.extraction = extraction},
                   [&](const ScanBand& band) { writer.write(band); });
        writer.finish();
        std::ifstream in(file, std::ios::binary);
        const std::string contents(std::istreambuf_iterator<char>(in), {});
        fs::remove(file);
        for (const char first : {'\0', '\1'})
            std::ofstream(folder / (std::to_string(static_cast<int>(extraction)) + std::to_string(first)),
                          std::ios::binary)
                << first << contents;
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("make_scan_seeds FOLDER\n", stderr);
        return 2;
    }
    try {
        fs::create_directories(argv[1]);
        seeds_of_scan_files(argv[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_scan_seeds: %s\n", error.what());
        return 1;
    }
}
