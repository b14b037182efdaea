// SPDX-License-Identifier: Apache-2.0
#include "input_stream.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "keikan/support/input_error.hpp"

namespace keikan {

InputStream::InputStream(const std::string& file) : std::istream(nullptr) {
    buffer_.name = file == "-" ? "standard input" : file;
    buffer_.descriptor = file == "-" ? STDIN_FILENO : open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (buffer_.descriptor < 0)
        throw InputError(file, "", std::string("cannot be read: ") + std::strerror(errno));
    rdbuf(&buffer_);
    exceptions(std::ios::badbit);  // an InputError of the buffer goes through to the caller
}

InputStream::~InputStream() {
    if (buffer_.descriptor != STDIN_FILENO) close(buffer_.descriptor);
}

InputStream::Buffer::int_type InputStream::Buffer::underflow() {
    ssize_t count = 0;
    do {
        count = ::read(descriptor, bytes.data(), bytes.size());
    } while (count < 0 && errno == EINTR);
    if (count < 0) throw InputError(name, "", std::string("cannot be read: ") + std::strerror(errno));
    setg(bytes.data(), bytes.data(), bytes.data() + count);
    return count > 0 ? traits_type::to_int_type(bytes[0]) : traits_type::eof();
}

}  // namespace keikan
