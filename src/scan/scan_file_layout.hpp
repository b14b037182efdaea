// SPDX-License-Identifier: Apache-2.0
//
// The bytes of a scan file, shared by writer and reader. docs/scan_file.md is the description for people.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace keikan::scan_file {

// All numbers are little-endian; a machine that is not would swap on the way in and out.
static_assert(std::endian::native == std::endian::little, "scan files are written as the memory is");

inline constexpr std::array<char, 8> kMagic{'\x89', 'K', 'S', 'C', 'A', 'N', '\r', '\n'};
inline constexpr std::uint32_t kVersion = 1;
/// A picture side beyond this is not drawn by any command, and would only be a way to ask for memory.
inline constexpr std::int32_t kLongestSide = 65536;

/// At the start of the file: known before the first band is.
struct Head {
    std::array<char, 8> magic = kMagic;
    std::uint32_t version = kVersion;
    std::uint32_t extraction = 0;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::uint64_t geometry_hash = 0;
    std::uint64_t checksum = 0;  ///< XXH3-64 of the bytes before
};

/// One for each band, after the bands.
struct TableEntry {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint64_t checksum = 0;  ///< XXH3-64 of the band's bytes
    std::int32_t first_row = 0;
    std::int32_t rows = 0;
};

/// The end of the file.
struct Tail {
    std::uint64_t table_offset = 0;
    std::uint64_t band_count = 0;
    std::uint64_t file_bytes = 0;
    std::uint64_t checksum = 0;  ///< XXH3-64 of head, table and the tail's bytes before
};

/// The start of a band. The arrays follow, in this order, each padded with zeros to a multiple of 8 bytes:
///   span_begin, divided_begin (rows + 1 values each), faces, spans, divided, and of the parts first all
///   weights, then all faces, then all centroids.
struct BandHead {
    std::int32_t first_row = 0;
    std::int32_t rows = 0;
    std::uint32_t faces = 0;
    std::uint32_t spans = 0;
    std::uint32_t divided = 0;
    std::uint32_t parts = 0;
};

struct FaceRecord {
    std::uint32_t id = 0;
    std::uint16_t object = 0;
    std::uint16_t material = 0;
    std::array<double, 3> plane{};
    std::array<double, 2> normal_at{};
    std::array<float, 9> normal{};
    std::array<float, 3> flat_normal{};
};

struct SpanRecord {
    std::int32_t x_begin = 0;
    std::int32_t x_end = 0;
    std::uint32_t face = 0;
};

struct DividedRecord {
    double background = 0;
    std::uint32_t part_end = 0;        ///< its parts start where those of the pixel before end
    std::uint32_t x_and_division = 0;  ///< 2 x + division
};

struct CentroidRecord {
    float x = 0;
    float y = 0;
};

// No padding anywhere: every byte of the file is a byte of a value, and is known.
static_assert(sizeof(Head) == 40 && std::has_unique_object_representations_v<Head>);
static_assert(sizeof(TableEntry) == 32 && std::has_unique_object_representations_v<TableEntry>);
static_assert(sizeof(Tail) == 32 && std::has_unique_object_representations_v<Tail>);
static_assert(sizeof(BandHead) == 24 && std::has_unique_object_representations_v<BandHead>);
static_assert(sizeof(FaceRecord) == 96 && sizeof(SpanRecord) == 12 && sizeof(DividedRecord) == 16 &&
              sizeof(CentroidRecord) == 8);

inline constexpr std::uint64_t padded(std::uint64_t bytes) {
    return (bytes + 7) / 8 * 8;
}

/// Length of a band in the file. The counts are 32 bits, so nothing overflows.
inline constexpr std::uint64_t band_bytes(const BandHead& head) {
    const std::uint64_t rows = static_cast<std::uint64_t>(static_cast<std::uint32_t>(head.rows)) + 1;
    return sizeof(BandHead) + 2 * padded(rows * sizeof(std::uint32_t)) + head.faces * sizeof(FaceRecord) +
           padded(head.spans * sizeof(SpanRecord)) + head.divided * sizeof(DividedRecord) +
           head.parts * (sizeof(double) + sizeof(CentroidRecord)) +
           padded(head.parts * sizeof(std::uint32_t));
}

}  // namespace keikan::scan_file
