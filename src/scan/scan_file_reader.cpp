// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "band_check.hpp"
#include "keikan/scan/scan_file.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "random_access_file.hpp"
#include "scan_file_checksum.hpp"
#include "scan_file_layout.hpp"

namespace keikan {
namespace {

using namespace scan_file;

[[noreturn]] void fail(const RandomAccessFile& file, const std::string& place, const std::string& reason) {
    throw InputError(file.name().string(), place, reason);
}

template <typename Value>
Value read_value(const RandomAccessFile& file, std::uint64_t offset) {
    Value value;
    file.read(offset, std::as_writable_bytes(std::span(&value, 1)));
    return value;
}

template <typename Value>
std::span<const std::byte> bytes_of(const Value& value) {
    return std::as_bytes(std::span(&value, 1));
}

Head read_head(const RandomAccessFile& file) {
    if (file.size() < sizeof(Head)) fail(file, "offset 0", "is no scan file: too short for a header");
    const Head head = read_value<Head>(file, 0);
    if (head.magic != kMagic) fail(file, "offset 0", "is no scan file");
    if (head.version != kVersion)
        fail(file, "offset 8",
             "is a scan file of version " + std::to_string(head.version) + "; this program reads version " +
                 std::to_string(kVersion));
    if (head.checksum != checksum(bytes_of(head).first(offsetof(Head, checksum))))
        fail(file, "offset 0", "the header is damaged");
    if (head.width < 1 || head.width > kLongestSide || head.height < 1 || head.height > kLongestSide)
        fail(file, "offset 16", "the picture's size is out of range");
    if (head.extraction > static_cast<std::uint32_t>(Extraction::Paper))
        fail(file, "offset 12", "names no extraction rule");
    return head;
}

Tail read_tail(const RandomAccessFile& file) {
    if (file.size() < sizeof(Head) + sizeof(Tail)) fail(file, "the end", "is cut off");
    const Tail tail = read_value<Tail>(file, file.size() - sizeof(Tail));
    // band_count is bounded before it is multiplied.
    if (tail.file_bytes != file.size() || tail.band_count > file.size() / sizeof(TableEntry) ||
        tail.table_offset != file.size() - sizeof(Tail) - tail.band_count * sizeof(TableEntry) ||
        tail.table_offset < sizeof(Head))
        fail(file, "the end", "is cut off or damaged");
    return tail;
}

std::vector<TableEntry> read_table(const RandomAccessFile& file, const Head& head, const Tail& tail) {
    std::vector<TableEntry> table(tail.band_count);
    file.read(tail.table_offset, std::as_writable_bytes(std::span(table)));
    std::vector<std::byte> covered;
    for (const auto bytes : {bytes_of(head), std::span<const std::byte>(std::as_bytes(std::span(table))),
                             bytes_of(tail).first(offsetof(Tail, checksum))})
        covered.insert(covered.end(), bytes.begin(), bytes.end());
    if (tail.checksum != checksum(covered)) fail(file, "the table of bands", "is damaged");

    // The bands follow each other without a gap, in the file as in the picture.
    std::uint64_t offset = sizeof(Head);
    std::int64_t row = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const TableEntry& entry = table[i];
        const std::string place = "band " + std::to_string(i);
        if (entry.offset != offset || entry.bytes < sizeof(BandHead) ||
            entry.bytes > tail.table_offset - offset)
            fail(file, place, "lies outside its place in the file");
        if (entry.first_row != row || entry.rows < 1 || entry.rows > head.height - row)
            fail(file, place, "does not hold the rows that are due");
        offset += entry.bytes;
        row += entry.rows;
    }
    if (offset != tail.table_offset) fail(file, "the table of bands", "leaves bytes without an owner");
    if (row != head.height) fail(file, "the table of bands", "leaves rows without a band");
    return table;
}

/// Takes the arrays of a band out of its bytes, one after the other.
class Sections {
  public:
    explicit Sections(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <typename Record, typename Take>
    void take(std::size_t count, const Take& take_record) {
        const std::byte* from = rest_.data();
        for (std::size_t i = 0; i < count; ++i, from += sizeof(Record)) {
            Record record;
            std::memcpy(&record, from, sizeof(Record));
            take_record(i, record);
        }
        rest_ = rest_.subspan(padded(count * sizeof(Record)));
    }

    void take(std::vector<std::uint32_t>& values, std::size_t count) {
        values.resize(count);
        std::memcpy(values.data(), rest_.data(), count * sizeof(std::uint32_t));
        rest_ = rest_.subspan(padded(count * sizeof(std::uint32_t)));
    }

  private:
    std::span<const std::byte> rest_;
};

SeenFace seen_face_of(const FaceRecord& record) {
    SeenFace face;
    face.id = record.id;
    face.object = record.object;
    face.material = record.material;
    face.plane = {record.plane[0], record.plane[1], record.plane[2]};
    face.normal_at = {record.normal_at[0], record.normal_at[1]};
    for (std::size_t i = 0; i < 9; ++i) face.normal[i / 3][i % 3] = record.normal[i];
    face.flat_normal = record.flat_normal;
    return face;
}

/// The band, its counts known to fit its bytes; nothing else is known yet.
ScanBand unpacked(const BandHead& head, std::span<const std::byte> bytes) {
    ScanBand band;
    band.first_row = head.first_row;
    band.rows = head.rows;
    const std::size_t row_ends = static_cast<std::size_t>(head.rows) + 1;
    Sections sections(bytes.subspan(sizeof(BandHead)));
    sections.take(band.span_begin, row_ends);
    sections.take(band.divided_begin, row_ends);
    band.faces.resize(head.faces);
    sections.take<FaceRecord>(head.faces,
                              [&](std::size_t i, const FaceRecord& r) { band.faces[i] = seen_face_of(r); });
    band.spans.resize(head.spans);
    sections.take<SpanRecord>(head.spans, [&](std::size_t i, const SpanRecord& r) {
        band.spans[i] = {r.x_begin, r.x_end, r.face};
    });
    band.divided.resize(head.divided);
    std::uint32_t part = 0;
    sections.take<DividedRecord>(head.divided, [&](std::size_t i, const DividedRecord& r) {
        band.divided[i] = {static_cast<std::int32_t>(r.x_and_division / 2),
                           static_cast<Division>(r.x_and_division % 2), part, r.part_end, r.background};
        part = r.part_end;
    });
    band.parts.resize(head.parts);
    sections.take<double>(head.parts, [&](std::size_t i, double weight) { band.parts[i].weight = weight; });
    sections.take<std::uint32_t>(head.parts,
                                 [&](std::size_t i, std::uint32_t face) { band.parts[i].face = face; });
    sections.take<CentroidRecord>(head.parts, [&](std::size_t i, const CentroidRecord& r) {
        band.parts[i].x = r.x;
        band.parts[i].y = r.y;
    });
    return band;
}

}  // namespace

struct ScanFileReader::Mapping {
    explicit Mapping(std::filesystem::path name) : file(std::move(name)) {}

    RandomAccessFile file;
    ScanHeader header;
    std::vector<TableEntry> table;
};

ScanFileReader::ScanFileReader(std::filesystem::path file)
    : mapping_(std::make_unique<Mapping>(std::move(file))) {
    const Head head = read_head(mapping_->file);
    const Tail tail = read_tail(mapping_->file);
    mapping_->table = read_table(mapping_->file, head, tail);
    mapping_->header = {
        {head.width, head.height}, static_cast<Extraction>(head.extraction), head.geometry_hash};
}

ScanFileReader::~ScanFileReader() = default;

const ScanHeader& ScanFileReader::header() const {
    return mapping_->header;
}

std::size_t ScanFileReader::band_count() const {
    return mapping_->table.size();
}

ScanBand ScanFileReader::band(std::size_t i) const {
    KEIKAN_CHECK(i < mapping_->table.size(), "band " << i << " of " << mapping_->table.size());
    const TableEntry& entry = mapping_->table[i];
    const std::string place = "band " + std::to_string(i);
    std::vector<std::byte> bytes(entry.bytes);
    mapping_->file.read(entry.offset, bytes);
    if (checksum(bytes) != entry.checksum) fail(mapping_->file, place, "is damaged");
    BandHead head;
    std::memcpy(&head, bytes.data(), sizeof(head));
    if (head.first_row != entry.first_row || head.rows != entry.rows)
        fail(mapping_->file, place, "holds other rows than the table says");
    if (band_bytes(head) != entry.bytes) fail(mapping_->file, place, "its counts do not fit its length");
    ScanBand band = unpacked(head, bytes);
    if (const auto wrong = what_is_wrong(band, mapping_->header.size.width))
        fail(mapping_->file, place, *wrong);
    return band;
}

}  // namespace keikan
