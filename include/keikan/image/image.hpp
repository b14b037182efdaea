// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "keikan/model/pixel.hpp"

namespace keikan {

/// Colour in linear light, sRGB primaries (ITU-R BT.709), 1 = display white.
struct Rgb {
    float r = 0;
    float g = 0;
    float b = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
    friend Rgb operator+(Rgb p, Rgb q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
    friend Rgb operator*(Rgb p, Rgb q) { return {p.r * q.r, p.g * q.g, p.b * q.b}; }
    friend Rgb operator*(float s, Rgb p) { return {s * p.r, s * p.g, s * p.b}; }
};

/// A rectangle of values, row by row from the top.
template <typename T>
class Image {
  public:
    Image() = default;
    explicit Image(ImageSize size, T value = T{})
        : size_(size),
          values_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), value) {}

    ImageSize size() const { return size_; }
    int width() const { return size_.width; }
    int height() const { return size_.height; }
    T& operator[](PixelIndex p) { return values_[at(p)]; }
    const T& operator[](PixelIndex p) const { return values_[at(p)]; }
    std::span<T> row(int y) {
        return std::span(values_).subspan(at({0, y}), static_cast<std::size_t>(size_.width));
    }
    std::span<const T> row(int y) const {
        return std::span(values_).subspan(at({0, y}), static_cast<std::size_t>(size_.width));
    }
    std::span<const T> values() const { return values_; }
    std::span<T> values() { return values_; }
    friend bool operator==(const Image&, const Image&) = default;

  private:
    std::size_t at(PixelIndex p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size_.width) +
               static_cast<std::size_t>(p.x);
    }
    ImageSize size_;
    std::vector<T> values_;
};

}  // namespace keikan
