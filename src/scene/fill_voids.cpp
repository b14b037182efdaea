// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "keikan/scene/height_grid.hpp"
#include "keikan/support/check.hpp"

namespace keikan {
namespace {

/// The nearest known sample towards one direction: how many steps away, and its height.
struct Sight {
    float steps = std::numeric_limits<float>::infinity();
    float height = 0;
};

struct WeightedMean {
    float weight = 0;
    float sum = 0;
};

/// Adds, for every sample, what is seen from it along the step (dx, dy). One sweep: what a sample sees is
/// what the next sample along the step is or sees.
void add_sights(int columns, int rows, const std::vector<float>& heights, int dx, int dy,
                std::vector<WeightedMean>& means) {
    const float step = std::hypot(static_cast<float>(dx), static_cast<float>(dy));
    const auto width = static_cast<std::size_t>(columns);
    std::vector<Sight> row_before(width), row_now(width);
    for (int j = 0; j < rows; ++j) {
        const int row = dy > 0 ? rows - 1 - j : j;  // sweep so that row + dy and column + dx come first
        for (int i = 0; i < columns; ++i) {
            const int column = dx > 0 ? columns - 1 - i : i;
            const auto at = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
            const int next_column = column + dx, next_row = row + dy;
            const bool inside = next_column >= 0 && next_column < columns && next_row >= 0 && next_row < rows;
            Sight seen;
            if (inside) {
                const Sight& next = (dy == 0 ? row_now : row_before)[static_cast<std::size_t>(next_column)];
                seen = {next.steps + step, next.height};
            }
            if (std::isfinite(seen.steps)) {
                const float weight = 1 / (seen.steps * seen.steps);
                means[at].weight += weight;
                means[at].sum += weight * seen.height;
            }
            row_now[static_cast<std::size_t>(column)] =
                std::isnan(heights[at]) ? seen : Sight{0, heights[at]};
        }
        std::swap(row_now, row_before);
    }
}

}  // namespace

std::size_t fill_voids(int columns, int rows, std::vector<float>& heights) {
    std::size_t voids = 0;
    double sum = 0;
    for (const float height : heights) {
        if (std::isnan(height)) {
            ++voids;
        } else {
            sum += static_cast<double>(height);
        }
    }
    if (voids == 0) return 0;
    KEIKAN_CHECK(voids < heights.size(), "a grid of voids only");
    const auto mean = static_cast<float>(sum / static_cast<double>(heights.size() - voids));

    std::vector<WeightedMean> means(heights.size());
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx != 0 || dy != 0) add_sights(columns, rows, heights, dx, dy, means);
        }
    }
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (std::isnan(heights[i])) heights[i] = means[i].weight > 0 ? means[i].sum / means[i].weight : mean;
    }
    return voids;
}

}  // namespace keikan
