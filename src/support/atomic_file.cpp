// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {

namespace fs = std::filesystem;

namespace {

/// A short name of its own beside `target`, so that the rename stays within one file system and the name
/// within the system's limit.
fs::path temporary_beside(const fs::path& target) {
    static std::atomic<unsigned> count = 0;
    const std::string name = ".keikan-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".tmp";
    return target.parent_path() / name;
}

}  // namespace

AtomicFile::AtomicFile(fs::path file) : file_(std::move(file)) {
    if (file_.empty()) throw InputError("the name of the file to write is empty");
    if (file_ == "-") {
        descriptor_ = STDOUT_FILENO;
        return;
    }
    std::error_code ignored;  // what cannot be looked at is reported by the attempt to open it
    const fs::file_status status = fs::status(file_, ignored);
    target_ = fs::is_symlink(file_, ignored) && fs::exists(status) ? fs::canonical(file_, ignored) : file_;
    if (fs::is_directory(status)) throw InputError(file_.string(), "", "cannot be written: it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        descriptor_ = open(file_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        temporary_ = temporary_beside(target_);
        descriptor_ = open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    if (descriptor_ < 0) {
        const int error = errno;
        temporary_.clear();  // nothing of ours to remove
        fail("cannot be written", error);
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0) {
            if (errno == EINTR) continue;
            fail("cannot be written", errno);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        size_ += static_cast<std::uint64_t>(written);
    }
}

void AtomicFile::overwrite(std::uint64_t offset, std::span<const std::byte> bytes) {
    KEIKAN_CHECK(can_overwrite() && offset + bytes.size() <= size_,
                 "nothing was written at offset " << offset);
    while (!bytes.empty()) {
        const ssize_t written = pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0) {
            if (errno == EINTR) continue;
            fail("cannot be written", errno);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

void AtomicFile::finish() {
    KEIKAN_CHECK(descriptor_ >= 0, "a file is finished once");
    const int descriptor = std::exchange(descriptor_, -1);
    // A full disk may show as late as here.
    if (descriptor != STDOUT_FILENO && close(descriptor) != 0) fail("cannot be written", errno);
    if (temporary_.empty()) return;
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot be put in its place", errno);
    temporary_.clear();
}

void AtomicFile::fail(const char* what, int error) {
    const std::string name = file_ == "-" ? "standard output" : file_.string();
    throw InputError(name, "", std::string(what) + ": " + std::generic_category().message(error));
}

void write_whole_file(const fs::path& file, std::string_view contents) {
    AtomicFile out(file);
    out.write(contents);
    out.finish();
}

}  // namespace keikan
