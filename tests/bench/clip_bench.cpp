// SPDX-License-Identifier: Apache-2.0
// Visible areas of the same pixels by our engines and by the libraries that a user would pick instead: one
// thread, one process. Run by scripts/bench; docs/numerics.md says what follows from it.
//
// The pixels are the same number of each ordered degenerate family (verify/fuzz), seed 1, planes left out.
// The libraries get the polygons already clipped to the pixel (verify/peers/prepared_pixel.hpp), which is not
// timed; our engines clip for themselves, which is.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "fuzz/degenerate_families.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "peers/peer.hpp"

namespace {

std::size_t allocations = 0;

void* counted(std::size_t size) {
    ++allocations;
    return std::malloc(size == 0 ? 1 : size);
}

}  // namespace

void* operator new(std::size_t size) {
    if (void* const memory = counted(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}

namespace {

using namespace keikan;

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kPixelsOfAFamily = 100;

/// These families are nothing special without their planes.
bool is_about_depth(fuzz::Family family) {
    using enum fuzz::Family;
    return family == Cyclic || family == Interpenetrating || family == Coplanar;
}

const std::vector<PixelCase>& pixel_cases() {
    static const std::vector<PixelCase> cases = [] {
        std::vector<PixelCase> made;
        for (std::size_t f = 0; f < fuzz::kFamilyNames.size(); ++f) {
            const auto family = static_cast<fuzz::Family>(f);
            if (is_about_depth(family)) continue;
            for (std::uint64_t i = 0; i < kPixelsOfAFamily; ++i) {
                made.push_back(fuzz::degenerate_case(family, kSeed, i));
                made.back().depth.reset();
            }
        }
        return made;
    }();
    return cases;
}

const std::vector<peers::PreparedPixel>& pixels() {
    static const std::vector<peers::PreparedPixel> prepared = [] {
        std::vector<peers::PreparedPixel> made;
        for (const PixelCase& pixel_case : pixel_cases()) made.push_back(peers::prepared_pixel(pixel_case));
        return made;
    }();
    return prepared;
}

/// Once over all pixels; how many were given up.
std::size_t ask_all(const peers::Ask& ask, peers::Answer& answer) {
    std::size_t failures = 0;
    for (const peers::PreparedPixel& pixel : pixels()) {
        try {
            ask(pixel, answer);
            benchmark::DoNotOptimize(answer.background);
        } catch (const std::exception&) {
            ++failures;
        }
    }
    return failures;
}

void divide_pixels(benchmark::State& state, const peers::Peer& peer) {
    const peers::Ask ask = peer.start();
    peers::Answer answer;
    std::size_t failures = ask_all(ask, answer);  // warms up: each object has seen every size of pixel
    const std::size_t before = allocations;
    for (auto _ : state) failures = ask_all(ask, answer);
    const auto asked = static_cast<double>(state.iterations()) * static_cast<double>(pixels().size());
    state.counters["pixels/s"] = benchmark::Counter(asked, benchmark::Counter::kIsRate);
    state.counters["allocations/pixel"] = static_cast<double>(allocations - before) / asked;
    state.counters["failures"] = static_cast<double>(failures);
}

}  // namespace

int main(int count, char** arguments) {
    benchmark::Initialize(&count, arguments);
    if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
    for (const peers::Peer& peer : {peers::splitting(), peers::traversal(), peers::published(),
                                    peers::boost_geometry(), peers::geos(), peers::clipper()})
        benchmark::RegisterBenchmark(peer.name.c_str(), [peer](benchmark::State& state) {
            divide_pixels(state, peer);
        })->Unit(benchmark::kMillisecond);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
