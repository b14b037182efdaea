// SPDX-License-Identifier: Apache-2.0
#include "keikan/scan/scan_file.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <random>

#include "../../src/scan/band_check.hpp"
#include "../../src/scan/scan_file_checksum.hpp"
#include "../../src/scan/scan_file_layout.hpp"
#include "../support/file_contents.hpp"
#include "../support/scratch_folder.hpp"
#include "keikan/support/input_error.hpp"
#include "small_scenes.hpp"

using namespace keikan;
using namespace keikan::small_scenes;
using namespace keikan::scan_file;

namespace {

/// Written over what is there, which is many times faster than a new file on some file systems.
void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    if (!std::filesystem::exists(file)) std::ofstream{file};
    std::fstream(file, std::ios::binary | std::ios::in | std::ios::out)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    std::filesystem::resize_file(file, bytes.size());
}

struct Contents {
    ImageSize size;
    Extraction extraction;
    std::uint64_t hash;
    std::vector<ScanBand> bands;
    friend bool operator==(const Contents&, const Contents&) = default;
};

Contents contents_of(const std::filesystem::path& file) {
    const ScanFileReader reader(file);
    Contents contents{reader.header().size, reader.header().extraction, reader.header().geometry_hash, {}};
    for (std::size_t i = 0; i < reader.band_count(); ++i) contents.bands.push_back(reader.band(i));
    return contents;
}

/// A small picture with everything that a band can hold.
Contents small_picture(Extraction extraction = Extraction::Outline) {
    const Camera view = camera({5, 3});
    std::vector<Object> objects;
    objects.push_back({"sheet", ObjectKind::Terrain, sheet(view, 1.5, 0.5, 5, 2, 12, 3)});
    objects.push_back({"wire", ObjectKind::Conductor, soup(view, 2, 1)});
    ScanOptions options;
    options.extraction = extraction;
    return {view.size, extraction, 0x0123456789ABCDEFu, scanned(geometry(objects), view, options)};
}

std::filesystem::path write(const Contents& contents, const std::filesystem::path& file) {
    ScanFileWriter writer(file, {contents.size, contents.extraction, contents.hash});
    for (const ScanBand& band : contents.bands) writer.write(band);
    writer.finish();
    return file;
}

/// What reading those bytes gives: the contents, or the error's text.
std::optional<Contents> read_or_error(const std::filesystem::path& file, std::string& error) {
    try {
        return contents_of(file);
    } catch (const InputError& e) {
        error = e.what();
        return std::nullopt;
    }
}

/// The file's bytes with band 0, the table and the tail changed as `change` wants, and all checksums right.
std::string forged(std::string bytes, const std::function<void(std::string& band)>& change) {
    Head head;
    std::memcpy(&head, bytes.data(), sizeof(head));
    Tail tail;
    std::memcpy(&tail, bytes.data() + bytes.size() - sizeof(tail), sizeof(tail));
    REQUIRE(tail.band_count == 1);
    TableEntry entry;
    std::memcpy(&entry, bytes.data() + tail.table_offset, sizeof(entry));
    std::string band = bytes.substr(entry.offset, entry.bytes);
    change(band);
    entry.bytes = band.size();
    entry.checksum = checksum(std::as_bytes(std::span(band)));
    tail.table_offset = entry.offset + entry.bytes;
    tail.file_bytes = tail.table_offset + sizeof(entry) + sizeof(tail);
    std::string covered(reinterpret_cast<const char*>(&head), sizeof(head));
    covered.append(reinterpret_cast<const char*>(&entry), sizeof(entry));
    covered.append(reinterpret_cast<const char*>(&tail), offsetof(Tail, checksum));
    tail.checksum = checksum(std::as_bytes(std::span(covered)));
    std::string file(reinterpret_cast<const char*>(&head), sizeof(head));
    file += band;
    file.append(reinterpret_cast<const char*>(&entry), sizeof(entry));
    file.append(reinterpret_cast<const char*>(&tail), sizeof(tail));
    return file;
}

}  // namespace

TEST_CASE("scan file: what was written is read, bit for bit", "[scan_file]") {
    const ScratchFolder folder;
    for (const Extraction extraction : {Extraction::Outline, Extraction::Paper}) {
        const Contents picture = small_picture(extraction);
        CHECK(contents_of(write(picture, folder.path / "a.scan")) == picture);
    }
    const Camera view = camera({64, 100});
    const Contents larger{view.size, Extraction::Outline, 1,
                          scanned(geometry(sheet(view, -4, -4, 110, 90, 14, 1)), view)};
    REQUIRE(larger.bands.size() > 1);
    CHECK(contents_of(write(larger, folder.path / "b.scan")) == larger);
}

TEST_CASE("scan file: it appears when it is finished, and not before", "[scan_file]") {
    const ScratchFolder folder;
    const Contents picture = small_picture();
    const auto file = folder.path / "a.scan";
    {
        ScanFileWriter writer(file, {picture.size, picture.extraction, picture.hash});
        for (const ScanBand& band : picture.bands) writer.write(band);
        CHECK_FALSE(std::filesystem::exists(file));
    }
    CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("scan file: a file cut off anywhere is refused", "[scan_file][hostile]") {
    const ScratchFolder folder;
    const std::string bytes = contents(write(small_picture(), folder.path / "a.scan"));
    const auto cut = folder.path / "cut.scan";
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        write_bytes(cut, bytes.substr(0, length));
        CHECK_THROWS_AS(contents_of(cut), InputError);
    }
    write_bytes(cut, bytes + '\0');
    CHECK_THROWS_AS(contents_of(cut), InputError);
}

TEST_CASE("scan file: a single flipped bit is found, wherever it is", "[scan_file][hostile]") {
    const ScratchFolder folder;
    const auto damaged = write(small_picture(), folder.path / "a.scan");
    const std::string bytes = contents(damaged);
    std::fstream file(damaged, std::ios::binary | std::ios::in | std::ios::out);
    const auto put = [&](std::size_t at, int value) {
        file.seekp(static_cast<std::streamoff>(at)).put(static_cast<char>(value)).flush();
    };
    std::size_t missed = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            put(at, bytes[at] ^ (1 << bit));
            std::string error;
            if (read_or_error(damaged, error)) ++missed;
        }
        put(at, bytes[at]);
    }
    CHECK(missed == 0);
    CHECK(contents_of(damaged) == small_picture());
}

TEST_CASE("scan file: random damage is found or does no harm", "[scan_file][hostile]") {
    const ScratchFolder folder;
    const Contents picture = small_picture();
    const std::string bytes = contents(write(picture, folder.path / "a.scan"));
    const auto damaged = folder.path / "damaged.scan";
    std::mt19937 random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        std::string changed = bytes;
        const std::size_t at = random() % changed.size();
        const std::size_t length = std::min<std::size_t>(1 + random() % 16, changed.size() - at);
        for (std::size_t i = 0; i < length; ++i) changed[at + i] = static_cast<char>(random());
        write_bytes(damaged, changed);
        std::string error;
        const auto read = read_or_error(damaged, error);
        CHECK((!read || *read == picture));
    }
}

TEST_CASE("scan file: damage under right checksums is refused, or is a band fit for shading",
          "[scan_file][hostile]") {
    const ScratchFolder folder;
    const std::string bytes = contents(write(small_picture(), folder.path / "a.scan"));
    const auto file = folder.path / "forged.scan";
    std::mt19937 random(2);
    int refused = 0;
    constexpr int kTrials = 4000;
    for (int trial = 0; trial < kTrials; ++trial) {
        write_bytes(file, forged(bytes, [&](std::string& band) {
                        for (std::size_t n = 1 + random() % 3; n > 0; --n) {
                            const std::size_t at = random() % band.size();
                            const char extremes[] = {'\0', '\x7F', '\xFF', static_cast<char>(random())};
                            band[at] = extremes[random() % 4];
                        }
                        if (random() % 8 == 0) band.resize(random() % (band.size() + 64));
                    }));
        std::string error;
        const auto read = read_or_error(file, error);
        if (!read) {
            ++refused;
            CHECK(error.find("forged.scan") != std::string::npos);
            CHECK(error.find('\n') == std::string::npos);
        } else {
            for (const ScanBand& band : read->bands) CHECK_FALSE(what_is_wrong(band, read->size.width));
        }
    }
    CHECK(refused > kTrials / 4);
}

TEST_CASE("scan file: counts that ask for more than the file holds ask for no memory",
          "[scan_file][hostile]") {
    const ScratchFolder folder;
    const std::string bytes = contents(write(small_picture(), folder.path / "a.scan"));
    const auto file = folder.path / "forged.scan";
    for (const std::size_t count :
         {offsetof(BandHead, faces), offsetof(BandHead, spans), offsetof(BandHead, divided),
          offsetof(BandHead, parts), offsetof(BandHead, rows), offsetof(BandHead, first_row)}) {
        write_bytes(file,
                    forged(bytes, [&](std::string& band) { band.replace(count, 4, "\xFF\xFF\xFF\xFF"); }));
        CHECK_THROWS_AS(contents_of(file), InputError);
    }
    std::string many_bands = bytes;
    many_bands.replace(many_bands.size() - sizeof(Tail) + offsetof(Tail, band_count), 8, 8, '\xFF');
    write_bytes(file, many_bands);
    CHECK_THROWS_AS(contents_of(file), InputError);
}

TEST_CASE("scan file: errors say which file, where and what", "[scan_file]") {
    const ScratchFolder folder;
    const auto file = folder.path / "a.scan";
    const auto error_of = [&](const std::string& bytes) {
        write_bytes(file, bytes);
        std::string error;
        CHECK_FALSE(read_or_error(file, error).has_value());
        return error;
    };
    CHECK(error_of("").find("is no scan file") != std::string::npos);
    CHECK(error_of(std::string(1000, 'x')).find("a.scan:offset 0: is no scan file") != std::string::npos);
    std::string bytes = contents(write(small_picture(), file));
    std::string newer = bytes;
    newer[8] = 9;
    CHECK(error_of(newer).find("version 9") != std::string::npos);
    std::string damaged = bytes;
    damaged[sizeof(Head) + 100] = static_cast<char>(damaged[sizeof(Head) + 100] ^ 1);
    CHECK(error_of(damaged).find("a.scan:band 0: is damaged") != std::string::npos);
    std::string error;
    CHECK_FALSE(read_or_error(folder.path / "none.scan", error).has_value());
    CHECK(error.find("none.scan") != std::string::npos);
    CHECK_FALSE(read_or_error(folder.path, error).has_value());
}
