// SPDX-License-Identifier: Apache-2.0
#include "keikan/wave/pixel_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "keikan/support/input_error.hpp"
#include "keikan/wave/counter_random.hpp"

namespace keikan {

namespace {

std::uint32_t reversed_bits(std::uint32_t v) {
    v = __builtin_bswap32(v);
    v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
    v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
    return ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
}

/// A bijection in which every bit depends on itself and the bits below only, at random: read backwards,
/// Owen's nested scrambling. Multiplying by even numbers and xor carry upwards alone.
std::uint32_t laine_karras(std::uint32_t v, std::uint32_t seed) {
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return v;
}

/// Sobol's second coordinate, read backwards: the matrix of Pascal's triangle modulo 2, whose columns follow
/// by v ^= v << 1. (The first coordinate, read backwards, is i itself.)
std::uint32_t reversed_sobol_second(std::uint32_t i) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 1; i != 0; i >>= 1, column ^= column << 1) result ^= column & (0u - (i & 1));
    return result;
}

/// Uniform points in a grid of `divisions` x `divisions` cells.
Point in_cell(int column, int row, int divisions, CounterRandom& random) {
    const double x = random.uniform(), y = random.uniform();
    return {(column + x) / divisions, (row + y) / divisions};
}

/// The point mirrored through the centre of the cell that it lies in.
Point mirrored_in_cell(Point p, int divisions) {
    const auto mirrored = [divisions](double v) {
        const double cell = std::min(std::floor(v * divisions), divisions - 1.0);
        return (2 * cell + 1) / divisions - v;
    };
    return {mirrored(p.x), mirrored(p.y)};
}

}  // namespace

Sampler sampler_of(const std::string& name) {
    if (name == "random") return Sampler::Random;
    if (name == "paper") return Sampler::Paper;
    if (name == "haber") return Sampler::Haber;
    if (name == "jittered") return Sampler::Jittered;
    if (name == "sobol") return Sampler::Sobol;
    throw InputError("'" + name + "' is no sampler; there are random, paper, haber, jittered, sobol");
}

int paper_divisions(std::size_t count) {
    return std::max(1, static_cast<int>(std::floor(std::sqrt(static_cast<double>(count) / 2))));
}

void sample_points(Sampler sampler, std::size_t count, std::uint64_t key, std::vector<Point>& points) {
    points.clear();
    CounterRandom random(key);
    const std::size_t at_least_one = std::max<std::size_t>(count, 1);
    const int pair_cells = paper_divisions(count);
    const int cells = std::max(1, static_cast<int>(std::floor(std::sqrt(static_cast<double>(at_least_one)))));
    switch (sampler) {
        case Sampler::Random:
            for (std::size_t i = 0; i < at_least_one; ++i) points.push_back(in_cell(0, 0, 1, random));
            break;
        case Sampler::Paper:
            for (std::size_t i = 0; i < std::max<std::size_t>(count / 2, 1); ++i) {
                points.push_back(in_cell(0, 0, 1, random));
                points.push_back(mirrored_in_cell(points.back(), pair_cells));
            }
            break;
        case Sampler::Haber:
            for (int row = 0; row < pair_cells; ++row)
                for (int column = 0; column < pair_cells; ++column) {
                    const Point p = in_cell(column, row, pair_cells, random);
                    points.push_back(p);
                    points.push_back(
                        {(2 * column + 1.0) / pair_cells - p.x, (2 * row + 1.0) / pair_cells - p.y});
                }
            break;
        case Sampler::Jittered:
            for (int row = 0; row < cells; ++row)
                for (int column = 0; column < cells; ++column)
                    points.push_back(in_cell(column, row, cells, random));
            break;
        case Sampler::Sobol:
            for (std::size_t i = 0; i < at_least_one; ++i)
                points.push_back(scrambled_sobol(static_cast<std::uint32_t>(i), key));
            break;
    }
}

Point scrambled_sobol(std::uint32_t i, std::uint64_t key) {
    const std::uint64_t seeds = mixed(key);
    const std::uint32_t x = reversed_bits(laine_karras(i, static_cast<std::uint32_t>(seeds)));
    const std::uint32_t y =
        reversed_bits(laine_karras(reversed_sobol_second(i), static_cast<std::uint32_t>(seeds >> 32)));
    return {(x + 0.5) * 0x1p-32, (y + 0.5) * 0x1p-32};
}

Point shuffled_sobol(std::uint32_t i, std::uint64_t key) {
    // Owen's scrambling turns a bit by the bits above it alone, so an aligned block of 2^m stays one.
    const auto seed = static_cast<std::uint32_t>(mixed(key ^ 0x5bd1e9955bd1e995u));
    return scrambled_sobol(reversed_bits(laine_karras(reversed_bits(i), seed)), key);
}

}  // namespace keikan
