// SPDX-License-Identifier: Apache-2.0
#include "random_access_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "keikan/support/input_error.hpp"

namespace keikan {

RandomAccessFile::RandomAccessFile(std::filesystem::path file) : file_(std::move(file)) {
    descriptor_ = file_ == "-" ? ::dup(STDIN_FILENO) : ::open(file_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    try {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0) fail(errno);
        if (S_ISDIR(status.st_mode)) fail(EISDIR);
        size_ = static_cast<std::uint64_t>(std::max<off_t>(status.st_size, 0));
        if (!S_ISREG(status.st_mode)) read_to_the_end();
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

RandomAccessFile::~RandomAccessFile() {
    ::close(descriptor_);
}

void RandomAccessFile::read_to_the_end() {
    in_memory_ = true;
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    for (;;) {
        const std::size_t at = memory_.size();
        memory_.resize(at + kPiece);
        const ssize_t got = ::read(descriptor_, memory_.data() + at, kPiece);
        memory_.resize(at + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        if (got == 0) break;
        if (got < 0 && errno != EINTR) fail(errno);
    }
    size_ = memory_.size();
}

void RandomAccessFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    if (in_memory_) {
        if (!bytes.empty()) std::memcpy(bytes.data(), memory_.data() + offset, bytes.size());
        return;
    }
    while (!bytes.empty()) {
        const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(errno);
        if (got == 0) throw InputError(file_.string(), "", "became shorter while it was read");
        bytes = bytes.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
}

void RandomAccessFile::fail(int error) const {
    throw InputError(file_.string(), "", "cannot be read: " + std::string(std::strerror(error)));
}

}  // namespace keikan
