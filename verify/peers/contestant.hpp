// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "keikan/model/pixel_case.hpp"
#include "peers/peer.hpp"
#include "peers/prepared_pixel.hpp"

namespace keikan::peers {

/// How a question ended.
enum class Outcome : std::uint8_t {
    Answered,
    Exception,  ///< it said that it has no answer: threw, exited with a code, wrote what is no answer
    Crash,      ///< it ended by a signal, or exited in the middle of a question
    Hang,       ///< it was stopped at the time limit
    NotAsked,   ///< the pixel has depth planes and the peer knows none, or too much went wrong before
};

struct Reply {
    Outcome outcome = Outcome::NotAsked;
    std::string reason;  ///< for Exception, Crash and Hang
    Answer answer;       ///< for Answered: finite numbers, an area for each polygon
};

/// The replies to a batch of pixels, and processor seconds spent on `timed_pixels` of them (a stretch in
/// which something hung or crashed is not timed).
struct Round {
    std::vector<Reply> replies;
    double seconds = 0;
    std::size_t timed_pixels = 0;
};

/// Pixel cases and their prepared forms, which are views into them.
struct Batch {
    explicit Batch(std::vector<PixelCase> of) : cases(std::move(of)) {
        for (const PixelCase& pixel_case : cases) prepared.push_back(prepared_pixel(pixel_case));
    }
    Batch(Batch&&) = default;
    Batch& operator=(Batch&&) = default;
    std::vector<PixelCase> cases;
    std::vector<PreparedPixel> prepared;
};

struct Watchdog {
    double seconds = 2;   ///< for one pixel, by the clock on the wall
    int most_hangs = 20;  ///< after so many hangs a contestant is asked no further
};

/// Whoever takes part. Asking never throws and always ends, whatever the contestant does.
struct Contestant {
    std::string name;
    std::string version;
    bool is_library = false;  ///< knows no depth, and sees PreparedPixel::in_pixel, not the case as it is
    /// For those who promise one: how far an area may be off in a pixel of so many faces.
    std::function<double(std::size_t faces)> promised_error;
    std::function<Round(const Batch& batch)> ask;
};

/// The peer in processes of its own, forked from this one: what it does to its memory, its time or its life
/// is its own. A process lives until a question kills it; the next one goes on behind that question. It may
/// take 4 GiB (beyond, allocations throw), and writes nothing to the terminal.
Contestant in_a_fork(const Peer& peer, const Watchdog& watchdog);

/// Any program that reads pixel cases from its standard input until that ends, and writes a line
/// {"id": ..., "areas": [...], "background": ...} for each, in their order, to its standard output; run by
/// /bin/sh -c. It is started for up to 256 cases at a time. Where anything goes wrong, smaller pieces are
/// tried until the pixel stands alone, so that the blame is right even if the program buffers its output.
/// The stated exact answers of a case are not passed on. After 64 single failures in a row without a single
/// answer it is asked no further.
///
/// Errors: InputError if the shell cannot find or run the command (when first asked).
Contestant external_program(const std::string& name, const std::string& command, const Watchdog& watchdog);

/// "segmentation fault" and the like.
std::string signal_in_words(int signal);

}  // namespace keikan::peers
