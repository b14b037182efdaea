// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>
#include <vector>

#include "keikan/compare/comparison.hpp"
#include "keikan/compare/sequence.hpp"

namespace keikan::compare {

/// A part of a picture.
struct Window {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const Window&, const Window&) = default;
};

/// The window of a quarter of the picture's width and height, at most, divided by `zoom` / 2, that holds the
/// most pixels of the mask; the first of several, row by row, on a grid of 4 pixels.
Window busiest_window(const Image<std::uint8_t>& mask, int zoom);

struct LabelledPicture {
    std::string label;
    const Image<Rgb>* picture = nullptr;
};

/// The window of each picture, every pixel drawn as zoom x zoom, side by side with labels.
Image<Rgb> zoomed_sheet(std::span<const LabelledPicture> pictures, const Window& window, int zoom,
                        int columns);

/// Frames of a sequence at a window: a row for each method, a column for each frame.
Image<Rgb> frames_sheet(const Sequence& sequence, const Window& window, int zoom);

/// The largest channel's error in every pixel, as shown (keikan/compare/picture_error.hpp), by one
/// logarithmic scale for all pictures: black below 1/4096, then blue, red, yellow to white at 1; with the
/// scale below.
Image<Rgb> error_picture(const Image<Rgb>& picture, const Image<Rgb>& truth, const std::string& label);

}  // namespace keikan::compare
