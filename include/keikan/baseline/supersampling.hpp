// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>

#include "keikan/baseline/faces_in_view.hpp"
#include "keikan/image/image.hpp"
#include "keikan/render/render_bands.hpp"

namespace keikan::baseline {

/// Where the samples of a pixel lie, in cells of columns x rows = N: `rows` is the smallest divisor of N that
/// is at least its square root, so that there are no fewer heights than widths (conductors are nearly level).
/// A prime N makes one column.
enum class SamplePattern {
    Grid,    ///< the middle of each cell: the same in all pixels
    Random,  ///< one place in each cell, uniform (jitter), keyed by pixel, sample and seed
};

struct SampleCells {
    int columns = 1;
    int rows = 1;
};
SampleCells sample_cells(int samples);

struct SupersamplingOptions {
    SamplePattern pattern = SamplePattern::Grid;
    int samples = 1;
    std::uint32_t seed = 1;
    /// Where it is not empty, pixels with 0 are left as background: for who looks at some pixels only.
    Image<std::uint8_t> only = {};
};

/// Supersampling by rays (Embree 3): `samples` rays a pixel against the projected faces (each cut into a fan
/// of triangles, in floats relative to the camera), in packets of eight neighbouring pixels (rtcIntersect8,
/// coherent). A face's share of a pixel is that of its hits; it is shaded once in a pixel, in the mean of the
/// places where it was hit, which costs less than shading every sample and tends to the same. Rays that hit
/// water look at it, one by one.
///
/// Properties:
///   (1) Shares are multiples of 1 / samples.
///   (2) A pixel follows from its place, the faces and the options alone: not from the number of threads.
/// Requires: samples >= 1; view outlives the makers.
/// Error:    Random: the share p of a face whose outline crosses n of the N cells is off by sqrt(n) / (2 N)
/// at
///           most (standard deviation), so N^(-3/4) for smooth outlines and N^(-1/2) for what is thinner than
///           a cell. Grid: 1 / rows for a level edge. Vertices are floats: 2^-24 of their distance.
/// Cost:     O(F log F) for the hierarchy, then O(N P log F) for P pixels.
/// Source:   Crow 1977, Whitted 1980 (Grid); Dippe, Wold 1985, Mitchell 1987 (Random).
std::function<BandMaker()> supersampling(const FacesInView& view, const SupersamplingOptions& options);

}  // namespace keikan::baseline
