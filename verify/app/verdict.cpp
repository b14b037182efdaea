// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

constexpr std::size_t kDisagreementsTold = 20;

std::string in_words(const crosscheck::CheckSummary& s) {
    return fmt::format(
        "{}: {} pixels, {} disagreements; largest area error {:.3g} ({:.3g} up to 8 faces), sum error "
        "{:.3g}; "
        "certified {}, rational {}, cgal {}; contacts {}, {} mismatches, {} folds; {:.1f} s",
        s.pass() ? "pass" : "FAIL", s.pixels, s.disagreement_count, s.max_area_error,
        s.max_area_error_to_8_faces, s.max_sum_error, s.rungs.certified, s.rungs.rational, s.rungs.cgal,
        s.contacts.checked, s.contacts.mismatches, s.contacts.folds, s.seconds);
}

}  // namespace

void tell_verdict(const crosscheck::CheckSummary& summary, const std::string& json, CommonOptions& common,
                  const std::function<std::string(const crosscheck::Disagreement&)>& replay_command) {
    common.pass = summary.pass();
    if (!common.json.empty() && common.json != "-") write_whole_file(common.json, json + "\n");
    std::puts(json.c_str());
    std::fflush(stdout);
    if (common.quiet) return;
    const std::size_t told = std::min(kDisagreementsTold, summary.disagreements.size());
    for (std::size_t i = 0; i < told; ++i) {
        const crosscheck::Disagreement& d = summary.disagreements[i];
        fmt::print(stderr, "{}\n  run again with: {}\n", text_of(d), replay_command(d));
    }
    if (summary.disagreement_count > told)
        fmt::print(stderr, "... and {} more\n", summary.disagreement_count - told);
    fmt::print(stderr, "{}\n", in_words(summary));
}

Engine engine_of(const std::string& name) {
    if (name == "splitting") return Engine::Splitting;
    if (name == "traversal") return Engine::Traversal;
    if (name == "published") return Engine::Published;
    throw InputError("--engine " + name + ": there are only: splitting, traversal, published");
}

std::string shell_word(const std::string& text) {
    const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("_-./+,:@").find(c) != std::string_view::npos;
    });
    if (plain) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string command_line(int argc, const char* const* argv) {
    std::string line = "keikan-verify";
    for (int i = 1; i < argc; ++i) line += " " + shell_word(argv[i]);
    return line;
}

}  // namespace keikan
