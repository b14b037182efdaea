// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <string>

/// A folder for the files of one test, gone with it.
struct ScratchFolder {
    std::filesystem::path path;

    explicit ScratchFolder(const std::string& name)
        : path(std::filesystem::temp_directory_path() / ("keikan-" + name + "-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path);
    }
    ~ScratchFolder() { std::filesystem::remove_all(path); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& file) const { return path / file; }
    long files() const {
        return std::distance(std::filesystem::directory_iterator(path),
                             std::filesystem::directory_iterator());
    }
};
