// SPDX-License-Identifier: Apache-2.0
//
// make_scan_seeds FOLDER: scan files of a small picture made by hand, each behind the byte that
// scan_file_fuzzer asks for.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "keikan/scan/scan_file.hpp"

namespace {

using namespace keikan;
namespace fs = std::filesystem;

constexpr int kWidth = 8, kHeight = 6, kRowsInABand = 3;

/// In each row a face, a pixel divided between two, and the background.
ScanBand band_from(int first_row, Division division) {
    ScanBand band;
    band.first_row = first_row;
    band.rows = kRowsInABand;
    band.faces.resize(2);
    band.faces[0].id = 7;
    band.faces[1].id = 9;
    for (SeenFace& face : band.faces) face.flat_normal = {0, 0, 1};
    for (std::uint32_t row = 0; row < kRowsInABand; ++row) {
        band.span_begin.push_back(2 * row);
        band.divided_begin.push_back(row);
        band.spans.push_back({0, 3, 0});
        band.spans.push_back({4, kWidth, Span::kBackground});
        band.divided.push_back({3, division, 2 * row, 2 * row + 2, 0.25});
        band.parts.push_back({0, 0.25F, 0.5F, 0.5});
        band.parts.push_back({1, 0.75F, 0.5F, 0.25});
    }
    band.span_begin.push_back(2 * kRowsInABand);
    band.divided_begin.push_back(kRowsInABand);
    return band;
}

void seeds_of_scan_files(const fs::path& folder) {
    for (const Extraction extraction : {Extraction::Outline, Extraction::Paper}) {
        const bool outline = extraction == Extraction::Outline;
        const fs::path file = folder / "whole.scan";
        ScanFileWriter writer(file, {{kWidth, kHeight}, extraction, 42});
        for (int row = 0; row < kHeight; row += kRowsInABand)
            writer.write(band_from(row, outline ? Division::ExactAreas : Division::Scanline));
        writer.finish();
        // A seed that the reader refuses would teach the fuzzer little.
        const ScanFileReader reader(file);
        for (std::size_t i = 0; i < reader.band_count(); ++i) reader.band(i);
        std::ifstream in(file, std::ios::binary);
        const std::string contents(std::istreambuf_iterator<char>(in), {});
        fs::remove(file);
        for (const char first : {'\0', '\1'})
            std::ofstream(folder / ((outline ? "outline" : "paper") + std::to_string(first)),
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
