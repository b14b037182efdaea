// SPDX-License-Identifier: Apache-2.0
#include "grey16_png.hpp"

#include <fmt/format.h>
#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstdio>
#include <memory>

#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 26;

/// libpng reports an error by a callback that must not return: the message is kept and `guarded` takes over.
struct Reader {
    std::string message;
    png_structp png;
    png_infop info = nullptr;

    Reader() : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning)) {
        if (png != nullptr) info = png_create_info_struct(png);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    [[noreturn]] static void on_error(png_structp png, png_const_charp message) {
        static_cast<Reader*>(png_get_error_ptr(png))->message = message;
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
};

/// Runs `step`, which owns nothing that would need a destructor, and turns libpng's error into ours.
template <typename Step>
void guarded(Reader& reader, const std::string& file, const Step& step) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) {
        throw InputError(file, "", fmt::format("is not a whole PNG: {}", reader.message));
    }
    step();
}

}  // namespace

Grey16 read_grey16_png(const std::string& file) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"), &std::fclose);
    if (!in) throw InputError(file, "", "cannot be opened");
    Reader reader;
    if (reader.info == nullptr) throw InputError(file, "", "cannot be read: no memory");
    guarded(reader, file, [&] {
        png_init_io(reader.png, in.get());
        png_read_info(reader.png, reader.info);
    });
    const auto columns = png_get_image_width(reader.png, reader.info);
    const auto rows = png_get_image_height(reader.png, reader.info);
    if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY ||
        png_get_bit_depth(reader.png, reader.info) != 16) {
        throw InputError(file, "", "is not a 16-bit grey PNG");
    }
    if (std::uint64_t{columns} * rows > kMostSamples) {
        throw InputError(file, "",
                         fmt::format("{} x {} samples are more than {}", columns, rows, kMostSamples));
    }
    Grey16 grid{static_cast<int>(columns), static_cast<int>(rows), {}};
    grid.values.resize(std::size_t{columns} * rows);
    std::uint16_t* const values = grid.values.data();
    guarded(reader, file, [&] {
        if constexpr (std::endian::native == std::endian::little) png_set_swap(reader.png);
        const int passes = png_set_interlace_handling(reader.png);
        png_read_update_info(reader.png, reader.info);
        for (int pass = 0; pass < passes; ++pass) {
            for (std::size_t row = 0; row < rows; ++row) {
                png_read_row(reader.png, reinterpret_cast<png_bytep>(values + row * columns), nullptr);
            }
        }
        png_read_end(reader.png, nullptr);
    });
    return grid;
}

}  // namespace keikan
