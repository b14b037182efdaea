// SPDX-License-Identifier: Apache-2.0
#include "grey16_png_writer.hpp"

#include <png.h>

#include <bit>
#include <csetjmp>

#include "keikan/support/check.hpp"

namespace keikan {
namespace {

void append(png_structp png, png_bytep bytes, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), size);
}

/// False where libpng gives up. Owns nothing that would need a destructor.
bool write(png_structp png, png_infop info, int columns, int rows, std::span<const std::uint16_t> values,
           std::string& bytes) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_compression_level(png, 9);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);  // neighbouring rows of ground are alike
    png_set_IHDR(png, info, static_cast<png_uint_32>(columns), static_cast<png_uint_32>(rows), 16,
                 PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
        png_write_row(
            png, reinterpret_cast<png_const_bytep>(values.data() + row * static_cast<std::size_t>(columns)));
    }
    png_write_end(png, info);
    return true;
}

}  // namespace

std::string grey16_png(int columns, int rows, std::span<const std::uint16_t> values) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    std::string bytes;
    const bool written = info != nullptr && write(png, info, columns, rows, values, bytes);
    png_destroy_write_struct(&png, &info);
    KEIKAN_CHECK(written, "a PNG of " << columns << " x " << rows << " could not be made");
    return bytes;
}

}  // namespace keikan
