// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// An empty folder of its own for the files of one test, gone with it.
struct ScratchFolder {
    std::filesystem::path path;

    explicit ScratchFolder(const std::string& name = "test") {
        std::string place =
            (std::filesystem::temp_directory_path() / ("keikan-" + name + "-XXXXXX")).string();
        if (mkdtemp(place.data()) == nullptr)
            throw std::filesystem::filesystem_error("no scratch folder", place,
                                                    std::error_code(errno, std::generic_category()));
        path = place;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& file) const { return path / file; }
    /// A new file in it, and where it is.
    std::filesystem::path write(const std::string& file, const std::string& text) const {
        std::ofstream(path / file, std::ios::binary) << text;
        return path / file;
    }
    long files() const {
        return std::distance(std::filesystem::directory_iterator(path),
                             std::filesystem::directory_iterator());
    }
};
