// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a scene file, beside the project's terrain: read, or refused by an InputError.
#include <filesystem>
#include <fstream>

#include "fuzzer.hpp"
#include "keikan/scene/scene.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

/// A folder of this process: scenes/fuzzed.json, and terrain/ as the scenes of the project name it.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("keikan-scene-" + std::to_string(getpid()));
    Folder() {
        std::filesystem::create_directories(path / "scenes");
        std::error_code exists;
        std::filesystem::create_directory_symlink(KEIKAN_SOURCE_DIR "/data/terrain", path / "terrain",
                                                  exists);
    }
    ~Folder() { std::filesystem::remove_all(path); }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Folder folder;
    const std::filesystem::path file = folder.path / "scenes" / "fuzzed.json";
    std::ofstream(file, std::ios::binary) << fuzzers::text_of(data, size);
    try {
        const Scene scene = read_scene(file);
        fuzzers::require(scene.camera.size.width > 0 && scene.camera.size.height > 0, "a picture has pixels");
        fuzzers::require(scene.document != nullptr, "a scene has its document");
    } catch (const InputError& error) {
        const std::string_view text = error.what();
        fuzzers::require(text.find('\n') == text.npos, "a complaint is one line: " + std::string(text));
    }
    return 0;
}
