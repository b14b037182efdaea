// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace keikan {

/// The pixel whose corner with the smallest coordinates is (x, y): column x, row y.
struct PixelIndex {
    int x = 0;
    int y = 0;
    friend bool operator==(const PixelIndex&, const PixelIndex&) = default;
};

/// Columns and rows of an image.
struct ImageSize {
    int width = 0;
    int height = 0;
    friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

}  // namespace keikan
