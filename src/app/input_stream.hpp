// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <istream>
#include <memory>
#include <streambuf>
#include <string>
#include <vector>

namespace keikan {

/// A file, or standard input for "-", read in large pieces. Its `rdbuf()->in_avail()` is 0 when the next
/// character has to be waited for, so that a reader can answer what it has while a pipe is quiet.
/// Errors: InputError naming the file where it cannot be opened or read.
class InputStream : public std::istream {
  public:
    explicit InputStream(const std::string& file);
    ~InputStream() override;
    /// What to call it in messages.
    const std::string& name() const { return buffer_.name; }

  private:
    struct Buffer : std::streambuf {
        int_type underflow() override;
        std::string name;
        int descriptor = -1;
        std::vector<char> bytes = std::vector<char>(1 << 20);
    };
    Buffer buffer_;
};

}  // namespace keikan
