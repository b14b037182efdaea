// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>

#include "keikan/model/pixel.hpp"
#include "keikan/scan/scan_band.hpp"
#include "keikan/scan/scan_scene.hpp"

namespace keikan {

/// What a scan file says of itself.
struct ScanHeader {
    ImageSize size;
    Extraction extraction = Extraction::Outline;
    std::uint64_t geometry_hash = 0;  ///< Scene::geometry_hash of the scene that it was made from
};

/// Writes a scan file (docs/scan_file.md) band by band. The file appears whole when `finish` returns, or not
/// at all. Errors: InputError naming the file when it cannot be written.
class ScanFileWriter {
  public:
    ScanFileWriter(std::filesystem::path file, const ScanHeader& header);
    ~ScanFileWriter();
    void write(const ScanBand& band);
    void finish();

  private:
    struct Writing;
    std::unique_ptr<Writing> writing_;
};

/// Reads a scan file, whoever wrote it. Opening checks magic, version, header checksum, file length and the
/// table of bands; each band is checked (checksum, every index and count) before it is handed out. A band may
/// be read from several threads at once.
/// Errors: InputError naming file, place (offset or band) and reason.
class ScanFileReader {
  public:
    explicit ScanFileReader(std::filesystem::path file);
    ~ScanFileReader();
    const ScanHeader& header() const;
    std::size_t band_count() const;
    ScanBand band(std::size_t i) const;

  private:
    struct Mapping;
    std::unique_ptr<Mapping> mapping_;
};

}  // namespace keikan
