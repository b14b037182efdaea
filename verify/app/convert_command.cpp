// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "keikan/cases/case_format.hpp"
#include "keikan/cases/svg.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan {
namespace {

constexpr std::size_t kMostCasesInADrawing = 1000;
constexpr std::size_t kPieceOfAFile = std::size_t{1} << 20;

struct ConvertCommand {
    std::string in, out, from, to;
};

/// The format that `option` names or, without it, the ending of `file`.
CaseFormat format_of(const std::string& file, const char* option, const std::string& word) {
    if (!word.empty()) {
        if (const auto format = case_format_named(word)) return *format;
        throw InputError(fmt::format("{} {}: there are only: jsonl, wkt, geojson, svg", option, word));
    }
    if (const auto format = case_format_of(file)) return *format;
    throw InputError(file, "",
                     fmt::format("has none of the endings .jsonl, .wkt, .geojson, .svg: use {}", option));
}

std::string drawing_of(const std::function<std::optional<PixelCase>()>& next, const std::string& name) {
    std::vector<PixelCase> cases;
    while (auto pixel_case = next()) {
        if (cases.size() == kMostCasesInADrawing)
            throw InputError(name, "",
                             fmt::format("holds more than the {} cases of a drawing", kMostCasesInADrawing));
        cases.push_back(std::move(*pixel_case));
    }
    return svg_from_cases(cases);
}

/// Everything is read before a byte goes to standard output; a file appears whole or not at all.
void convert_cases(const std::function<std::optional<PixelCase>()>& next, CaseFormat to, AtomicFile& out,
                   bool hold_back) {
    std::string text;
    while (const auto pixel_case = next()) {
        text += text_of_case(*pixel_case, to);
        if (hold_back || text.size() < kPieceOfAFile) continue;
        out.write(text);
        text.clear();
    }
    out.write(text);
}

void convert(const ConvertCommand& command) {
    const CaseFormat from = format_of(command.in, "--from", command.from);
    const CaseFormat to = format_of(command.out, "--to", command.to);
    if (from == CaseFormat::Svg) throw InputError(command.in, "", "is a drawing, which cannot be read back");
    std::ifstream file;
    const bool standard_input = command.in == "-";
    const std::string name = standard_input ? "standard input" : command.in;
    if (!standard_input) file.open(command.in, std::ios::binary);
    if (!file) throw InputError(command.in, "", "cannot be opened");
    const auto next = case_reader(standard_input ? std::cin : file, name, from);
    AtomicFile out(command.out);
    if (to == CaseFormat::Svg)
        out.write(drawing_of(next, name));
    else
        convert_cases(next, to, out, !out.can_overwrite());
    out.finish();
}

}  // namespace

void add_convert_command(CLI::App& app) {
    auto* const sub = app.add_subcommand(
        "convert", "Pixel cases from one kind of file into another: pixel cases, WKT, GeoJSON, SVG");
    const auto command = std::make_shared<ConvertCommand>();
    sub->add_option("IN", command->in, "File to read, or - for standard input")->required();
    sub->add_option("OUT", command->out, "File to write, or - for standard output")->required();
    sub->add_option("--from", command->from,
                    "What IN is: jsonl, wkt, geojson (by default, what its ending says)");
    sub->add_option("--to", command->to,
                    "What OUT is to be: jsonl, wkt, geojson, svg (by default, what its ending says)");
    sub->callback([command] { convert(*command); });
}

}  // namespace keikan
