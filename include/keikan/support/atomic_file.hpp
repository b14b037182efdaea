// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace keikan {

/// Writes a file whole or not at all: into a temporary name in the same folder, which `finish` renames.
/// Without `finish`, or when anything fails, the temporary file is removed and what stood under the name
/// before stays as it was.
///
/// "-" is standard output, and what is there already and is no regular file (a device, a pipe) is written to
/// directly: it cannot be replaced. There, bytes go out as they come.
///
/// Errors: InputError naming the file and the system's reason, from the constructor on (a folder that is
///         missing shows before any work is done).
class AtomicFile {
  public:
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Appends. Every call goes to the system: hand over large pieces.
    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text.data(), text.size()))); }

    /// Writes over bytes that have been written already. Requires: `can_overwrite()`.
    void overwrite(std::uint64_t offset, std::span<const std::byte> bytes);
    bool can_overwrite() const { return !temporary_.empty(); }

    /// Bytes appended so far.
    std::uint64_t size() const { return size_; }

    /// The file appears under its name.
    void finish();

  private:
    [[noreturn]] void fail(const char* what, int error);

    std::filesystem::path file_;       ///< as the caller named it, for messages
    std::filesystem::path target_;     ///< symbolic links resolved
    std::filesystem::path temporary_;  ///< empty: written to directly
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

/// One text or picture at once. Errors: as AtomicFile.
void write_whole_file(const std::filesystem::path& file, std::string_view contents);

}  // namespace keikan
