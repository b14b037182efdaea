// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace keikan {

/// A file to read from anywhere, by several threads at once. "-", pipes and other things that cannot be
/// read from anywhere are read to their end first, into memory. A regular file is read piece by piece rather
/// than mapped: one that shrinks meanwhile is then an error, not a fault.
/// Errors: InputError naming the file and the system's reason.
class RandomAccessFile {
  public:
    explicit RandomAccessFile(std::filesystem::path file);
    ~RandomAccessFile();
    RandomAccessFile(const RandomAccessFile&) = delete;
    RandomAccessFile& operator=(const RandomAccessFile&) = delete;

    std::uint64_t size() const { return size_; }
    const std::filesystem::path& name() const { return file_; }
    /// Fills `bytes` from `offset` on. Requires: offset + bytes.size() <= size().
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;

  private:
    void read_to_the_end();
    [[noreturn]] void fail(int error) const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    bool in_memory_ = false;
    std::vector<std::byte> memory_;
    std::uint64_t size_ = 0;
};

}  // namespace keikan
