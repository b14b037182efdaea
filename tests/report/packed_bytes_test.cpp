// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/packed_bytes.hpp"

#include <zlib.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "report/error_histogram.hpp"

using namespace keikan::report;

namespace {

std::vector<std::uint8_t> bytes_of_base64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') break;
        group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::uint8_t>(group >> bits));
    }
    return bytes;
}

std::string unpacked_text(const std::string& text, std::size_t size) {
    const std::vector<std::uint8_t> bytes = bytes_of_base64(text);
    std::string result(size, ' ');
    uLongf there = size;
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(result.data()), &there, bytes.data(), bytes.size()) == Z_OK);
    REQUIRE(there == size);
    return result;
}

double value_of_half(std::uint16_t bits) {
    const double sign = (bits & 0x8000) != 0 ? -1 : 1;
    const int exponent = bits >> 10 & 31, part = bits & 1023;
    if (exponent == 31) return part != 0 ? NAN : sign * HUGE_VAL;
    return exponent == 0 ? sign * std::ldexp(part, -24) : sign * std::ldexp(1024 + part, exponent - 25);
}

}  // namespace

TEST_CASE("packed: what is packed comes out again, whatever its length", "[report]") {
    for (std::size_t n = 0; n < 70; ++n) {
        std::string text;
        for (std::size_t i = 0; i < n; ++i) text += static_cast<char>(i * 37 % 251);
        CHECK(unpacked_text(packed(text), n) == text);
    }
}

TEST_CASE("packed_planes: the lowest bytes come first", "[report]") {
    const std::vector<std::uint16_t> values{0x0102, 0x0304};
    CHECK(unpacked_text(packed_planes(values), 4) == "\x02\x04\x01\x03");
    const std::vector<float> ones{1.0f};
    CHECK(unpacked_text(packed_planes(ones), 4) == std::string("\0\0\x80\x3f", 4));
}

TEST_CASE("half_float: every half comes back, and what lies between goes to the nearest, ties to even",
          "[report]") {
    for (std::uint32_t bits = 0; bits < 0x7c00; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        REQUIRE(half_float(static_cast<float>(value_of_half(half))) == half);
        REQUIRE(half_float(-static_cast<float>(value_of_half(half))) == (half | 0x8000));
        if (bits == 0x7bff) break;
        const double next = value_of_half(static_cast<std::uint16_t>(bits + 1));
        const auto middle = static_cast<float>((value_of_half(half) + next) / 2);
        const auto even = static_cast<std::uint16_t>(bits + bits % 2);
        REQUIRE(half_float(middle) == even);
        REQUIRE(half_float(std::nextafter(middle, 0.0f)) == half);
    }
    CHECK(half_float(65519.0f) == 0x7bff);
    CHECK(half_float(65520.0f) == 0x7c00);
    CHECK(std::isnan(value_of_half(half_float(std::numeric_limits<float>::quiet_NaN()))));
}

TEST_CASE("ErrorHistogram: a bin for each halving of the bound, its upper end within", "[report]") {
    ErrorHistogram histogram;
    histogram.add(0, 1);
    histogram.add(1, 1);
    histogram.add(0.5, 1);
    histogram.add(std::nextafter(0.5, 1.0), 1);
    histogram.add(1e-30, 1);
    histogram.add(std::nextafter(1.0, 2.0), 1);
    histogram.add(HUGE_VAL, 1);
    CHECK(histogram.none == 1);
    CHECK(histogram.bins[11] == 2);
    CHECK(histogram.bins[10] == 1);
    CHECK(histogram.bins[0] == 1);
    CHECK(histogram.beyond == 2);
}
