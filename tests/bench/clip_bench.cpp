// SPDX-License-Identifier: Apache-2.0
// Visible areas of the same pixels by our engines and by the libraries that a user would pick instead: one
// thread, one process. Run by scripts/bench; docs/numerics.md says what follows from it.
//
// The pixels are the same number of each ordered degenerate family (verify/fuzz), seed 1, planes left out.
// The libraries get the polygons already clipped to the pixel (verify/peers/prepared_pixel.hpp), which is not
// timed; our engines clip for themselves, which is.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "../support/counted_allocations.hpp"
#include "fuzz/degenerate_families.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "peers/peer.hpp"

namespace {

using namespace keikan;
using test::allocations;

constexpr std::uint64_t kSeed = 1;
constexpr int kPixelsOfAFamily = 100;
constexpr int kRepetitions = 5;

/// These families are nothing special without their planes, or once their polygons are cut to the pixel.
bool is_left_out(fuzz::Family family) {
    using enum fuzz::Family;
    return family == Cyclic || family == Interpenetrating || family == Coplanar || family == FarPowers;
}

const std::vector<PixelCase>& pixel_cases() {
    static const std::vector<PixelCase> cases = [] {
        std::vector<PixelCase> made;
        for (std::size_t f = 0; f < fuzz::kFamilyNames.size(); ++f) {
            const auto family = static_cast<fuzz::Family>(f);
            if (is_left_out(family)) continue;
            for (int i = 0; i < kPixelsOfAFamily; ++i) {
                made.push_back(fuzz::degenerate_case(family, kSeed, static_cast<std::uint64_t>(i)));
                made.back().depth.reset();
            }
        }
        return made;
    }();
    return cases;
}

using Pixels = std::vector<peers::PreparedPixel>;

/// The polygons as they come: huge, far away, with collinear corners. The libraries never see them.
const Pixels& pixels_as_they_come() {
    static const Pixels pixels = [] {
        Pixels made;
        for (const PixelCase& pixel_case : pixel_cases()) made.push_back(peers::prepared_pixel(pixel_case));
        return made;
    }();
    return pixels;
}

/// Cut to the pixel and set straight beforehand, for everybody.
const Pixels& pixels_cut() {
    static const Pixels pixels = [] {
        Pixels made = pixels_as_they_come();
        for (peers::PreparedPixel& pixel : made) {
            pixel.pixel = {};
            for (std::size_t i = 0; i < pixel.faces.size(); ++i) pixel.faces[i].outline = pixel.in_pixel[i];
        }
        return made;
    }();
    return pixels;
}

/// Once over all pixels; how many were given up.
std::size_t ask_all(const peers::Ask& ask, const Pixels& pixels, peers::Answer& answer) {
    std::size_t failures = 0;
    for (const peers::PreparedPixel& pixel : pixels) {
        try {
            ask(pixel, answer);
            benchmark::DoNotOptimize(answer.background);
        } catch (const std::exception&) {
            ++failures;
        }
    }
    return failures;
}

void divide_pixels(benchmark::State& state, const peers::Peer& peer, const Pixels& pixels) {
    const peers::Ask ask = peer.start();
    peers::Answer answer;
    std::size_t failures = ask_all(ask, pixels, answer);  // warms up: each size of pixel has been seen
    std::size_t allocated = 0;
    for (auto _ : state) {
        const std::size_t before = allocations;
        failures = ask_all(ask, pixels, answer);
        allocated += allocations - before;
    }
    const auto asked = static_cast<double>(state.iterations()) * static_cast<double>(pixels.size());
    state.counters["pixels/s"] = benchmark::Counter(asked, benchmark::Counter::kIsRate);
    state.counters["allocations/pixel"] = static_cast<double>(allocated) / asked;
    state.counters["failures"] = static_cast<double>(failures);
}

/// Google Benchmark's own lines go to standard error; the best repetition of each, in the order given, as a
/// table to standard output.
class RatioTable : public benchmark::ConsoleReporter {
  public:
    RatioTable() : ConsoleReporter(OO_None) { SetOutputStream(&std::cerr); }

    void add_row(const std::string& name) { rows_.push_back({name}); }

    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            const auto row = std::ranges::find(rows_, run.run_name.function_name, &Row::name);
            if (run.run_type != Run::RT_Iteration || row == rows_.end()) continue;
            row->pixels_a_second = std::max(row->pixels_a_second, run.counters.at("pixels/s").value);
            row->allocations = run.counters.at("allocations/pixel").value;
            row->failures = run.counters.at("failures").value;
        }
    }

    void print() const {
        std::printf("%zu pixels, %d of each family, one thread, processor time, best of %d\n\n",
                    pixel_cases().size(), kPixelsOfAFamily, kRepetitions);
        std::puts("| | pixels/s | of splitting | allocations/pixel | given up |\n|---|---:|---:|---:|---:|");
        for (const Row& row : rows_)
            if (row.pixels_a_second > 0)
                std::printf("| %s | %.0f | %.3f | %.4g | %.0f |\n", row.name.c_str(), row.pixels_a_second,
                            row.pixels_a_second / rows_.front().pixels_a_second, row.allocations,
                            row.failures);
    }

  private:
    struct Row {
        std::string name;
        double pixels_a_second = 0;
        double allocations = 0;
        double failures = 0;
    };
    std::vector<Row> rows_;
};

void add(RatioTable& table, const peers::Peer& peer, const Pixels& pixels, const std::string& note = "") {
    const std::string name = peer.name + note;
    table.add_row(name);
    benchmark::RegisterBenchmark(
        name.c_str(), [peer, &pixels](benchmark::State& state) { divide_pixels(state, peer, pixels); })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(kRepetitions);
}

}  // namespace

int main(int count, char** arguments) {
    // Repetitions take turns, so that a busy minute of the machine meets everybody.
    std::string turns = "--benchmark_enable_random_interleaving=true", shortly = "--benchmark_min_time=0.1";
    std::vector<char*> all{arguments[0], turns.data(), shortly.data()};
    all.insert(all.end(), arguments + 1, arguments + count);
    int given = static_cast<int>(all.size());
    benchmark::Initialize(&given, all.data());
    if (benchmark::ReportUnrecognizedArguments(given, all.data())) return 2;

    RatioTable table;
    for (const peers::Peer& peer : {peers::splitting(), peers::traversal(), peers::published(),
                                    peers::boost_geometry(), peers::geos(), peers::clipper()})
        add(table, peer, pixels_cut());
    add(table, peers::splitting(), pixels_as_they_come(), ", cutting too");
    add(table, peers::traversal(), pixels_as_they_come(), ", cutting too");
    benchmark::RunSpecifiedBenchmarks(&table);
    table.print();
    return 0;
}
