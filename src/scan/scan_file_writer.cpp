// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <span>
#include <vector>

#include "keikan/scan/scan_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/check.hpp"
#include "scan_file_checksum.hpp"
#include "scan_file_layout.hpp"

namespace keikan {
namespace {

using namespace scan_file;

/// The bytes of a band, appended section by section into memory that is kept from band to band.
class Bytes {
  public:
    void clear() { bytes_.clear(); }
    std::span<const std::byte> all() const { return bytes_; }

    template <typename Value>
    void append(std::span<const Value> values) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + padded(values.size_bytes()));
        if (!values.empty()) std::memcpy(bytes_.data() + at, values.data(), values.size_bytes());
    }

    /// `count` records, each made by `record(i)` where it will stand.
    template <typename Record, typename Make>
    void append_records(std::size_t count, const Make& record) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + padded(count * sizeof(Record)));
        std::byte* to = bytes_.data() + at;
        for (std::size_t i = 0; i < count; ++i, to += sizeof(Record)) {
            const Record value = record(i);
            std::memcpy(to, &value, sizeof(Record));
        }
    }

  private:
    std::vector<std::byte> bytes_;
};

template <typename Value>
std::span<const std::byte> bytes_of(const Value& value) {
    return std::as_bytes(std::span(&value, 1));
}

FaceRecord record_of(const SeenFace& face) {
    FaceRecord record{face.id,
                      face.object,
                      face.material,
                      {face.plane.a, face.plane.b, face.plane.c},
                      {face.normal_at.x, face.normal_at.y},
                      {},
                      face.flat_normal};
    for (std::size_t i = 0; i < 9; ++i) record.normal[i] = face.normal[i / 3][i % 3];
    return record;
}

void append_band(const ScanBand& band, Bytes& bytes) {
    const BandHead head{band.first_row,
                        band.rows,
                        static_cast<std::uint32_t>(band.faces.size()),
                        static_cast<std::uint32_t>(band.spans.size()),
                        static_cast<std::uint32_t>(band.divided.size()),
                        static_cast<std::uint32_t>(band.parts.size())};
    bytes.append(std::span(&head, 1));
    bytes.append<std::uint32_t>(band.span_begin);
    bytes.append<std::uint32_t>(band.divided_begin);
    bytes.append_records<FaceRecord>(band.faces.size(),
                                     [&](std::size_t i) { return record_of(band.faces[i]); });
    bytes.append_records<SpanRecord>(band.spans.size(), [&](std::size_t i) {
        return SpanRecord{band.spans[i].x_begin, band.spans[i].x_end, band.spans[i].face};
    });
    bytes.append_records<DividedRecord>(band.divided.size(), [&](std::size_t i) {
        const DividedPixel& pixel = band.divided[i];
        return DividedRecord{
            pixel.background, pixel.part_end,
            2 * static_cast<std::uint32_t>(pixel.x) + static_cast<std::uint32_t>(pixel.division)};
    });
    const std::size_t parts = band.parts.size();
    bytes.append_records<double>(parts, [&](std::size_t i) { return band.parts[i].weight; });
    bytes.append_records<std::uint32_t>(parts, [&](std::size_t i) { return band.parts[i].face; });
    bytes.append_records<CentroidRecord>(parts, [&](std::size_t i) {
        return CentroidRecord{band.parts[i].x, band.parts[i].y};
    });
    KEIKAN_CHECK(bytes.all().size() == band_bytes(head), "a band of " << bytes.all().size() << " bytes");
}

}  // namespace

struct ScanFileWriter::Writing {
    explicit Writing(std::filesystem::path name) : file(std::move(name)) {}

    AtomicFile file;
    Head head;
    std::vector<TableEntry> table;
    Bytes bytes;
    int next_row = 0;
};

ScanFileWriter::ScanFileWriter(std::filesystem::path file, const ScanHeader& header)
    : writing_(std::make_unique<Writing>(std::move(file))) {
    KEIKAN_CHECK(header.size.width >= 1 && header.size.width <= kLongestSide && header.size.height >= 1 &&
                     header.size.height <= kLongestSide,
                 "a picture of " << header.size.width << " x " << header.size.height);
    Head& head = writing_->head;
    head.extraction = static_cast<std::uint32_t>(header.extraction);
    head.width = header.size.width;
    head.height = header.size.height;
    head.geometry_hash = header.geometry_hash;
    head.checksum = checksum(bytes_of(head).first(offsetof(Head, checksum)));
    writing_->file.write(bytes_of(head));
}

ScanFileWriter::~ScanFileWriter() = default;

void ScanFileWriter::write(const ScanBand& band) {
    KEIKAN_CHECK(band.first_row == writing_->next_row,
                 "rows from " << band.first_row << " were written when " << writing_->next_row << " was due");
    writing_->bytes.clear();
    append_band(band, writing_->bytes);
    const auto bytes = writing_->bytes.all();
    writing_->table.push_back(
        {writing_->file.size(), bytes.size(), checksum(bytes), band.first_row, band.rows});
    writing_->file.write(bytes);
    writing_->next_row += band.rows;
}

void ScanFileWriter::finish() {
    KEIKAN_CHECK(writing_->next_row == writing_->head.height,
                 writing_->next_row << " of " << writing_->head.height << " rows were written");
    Tail tail;
    tail.table_offset = writing_->file.size();
    tail.band_count = writing_->table.size();
    tail.file_bytes = tail.table_offset + tail.band_count * sizeof(TableEntry) + sizeof(Tail);
    Bytes covered;
    covered.append(std::span<const Head>(&writing_->head, 1));
    covered.append(std::span<const TableEntry>(writing_->table));
    covered.append(std::span<const Tail>(&tail, 1));
    tail.checksum = checksum(covered.all().first(covered.all().size() - sizeof(tail.checksum)));
    writing_->file.write(std::as_bytes(std::span(writing_->table)));
    writing_->file.write(bytes_of(tail));
    writing_->file.finish();
}

}  // namespace keikan
