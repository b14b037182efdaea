// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a scan file. If the first byte is odd, the checksums of the rest are set right before it is
// read, so that what lies behind them is tried too.
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "../../src/scan/scan_file_checksum.hpp"
#include "../../src/scan/scan_file_layout.hpp"
#include "fuzzer.hpp"
#include "keikan/scan/scan_file.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

using namespace scan_file;

template <typename Record>
Record record_at(const std::string& file, std::size_t offset) {
    Record record;
    std::memcpy(&record, file.data() + offset, sizeof record);
    return record;
}

template <typename Record>
void set_record(std::string& file, std::size_t offset, const Record& record) {
    std::memcpy(file.data() + offset, &record, sizeof record);
}

std::span<const std::byte> bytes_of(const std::string& text, std::size_t begin, std::size_t size) {
    return std::as_bytes(std::span(text)).subspan(begin, size);
}

void set_checksums(std::string& file) {
    if (file.size() < sizeof(Head) + sizeof(Tail)) return;
    auto head = record_at<Head>(file, 0);
    head.checksum = checksum(bytes_of(file, 0, sizeof(Head) - sizeof head.checksum));
    set_record(file, 0, head);
    const std::size_t tail_at = file.size() - sizeof(Tail);
    auto tail = record_at<Tail>(file, tail_at);
    tail.file_bytes = file.size();
    const bool has_table = tail.table_offset <= tail_at &&
                           tail.band_count == (tail_at - tail.table_offset) / sizeof(TableEntry) &&
                           (tail_at - tail.table_offset) % sizeof(TableEntry) == 0;
    if (has_table) {
        for (std::uint64_t at = tail.table_offset; at < tail_at; at += sizeof(TableEntry)) {
            auto entry = record_at<TableEntry>(file, at);
            if (entry.offset > tail_at || entry.bytes > tail_at - entry.offset) continue;
            entry.checksum = checksum(bytes_of(file, entry.offset, entry.bytes));
            set_record(file, at, entry);
        }
        set_record(file, tail_at, tail);
        // The layout's order: head, table, and the tail's bytes before its checksum.
        const std::string summed = file.substr(0, sizeof(Head)) +
                                   file.substr(tail.table_offset, tail_at - tail.table_offset) +
                                   file.substr(tail_at, sizeof(Tail) - sizeof tail.checksum);
        tail.checksum = checksum(bytes_of(summed, 0, summed.size()));
    }
    set_record(file, tail_at, tail);
}

/// A file without a name.
class MemoryFile {
  public:
    explicit MemoryFile(const std::string& contents) : descriptor_(memfd_create("scan", MFD_CLOEXEC)) {
        fuzzers::require(descriptor_ >= 0 && write(descriptor_, contents.data(), contents.size()) ==
                                                 static_cast<ssize_t>(contents.size()),
                         "there is room for a file");
    }
    ~MemoryFile() { close(descriptor_); }
    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    std::string contents = fuzzers::text_of(data + 1, size - 1);
    if (data[0] % 2 == 1) set_checksums(contents);
    const MemoryFile file(contents);
    try {
        const ScanFileReader reader(file.path());
        for (std::size_t i = 0; i < reader.band_count(); ++i) {
            const ScanBand band = reader.band(i);
            // What shading relies on.
            for (const Span& span : band.spans)
                fuzzers::require(span.face == Span::kBackground || span.face < band.faces.size(),
                                 "a span's face");
            for (const SeenPart& part : band.parts)
                fuzzers::require(part.face < band.faces.size(), "a part's face");
            for (const DividedPixel& pixel : band.divided)
                fuzzers::require(pixel.part_begin <= pixel.part_end && pixel.part_end <= band.parts.size() &&
                                     pixel.x >= 0 && pixel.x < reader.header().size.width,
                                 "a divided pixel's parts");
        }
    } catch (const InputError&) {
    }
    return 0;
}
