// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "report/error_histogram.hpp"
#include "report/junit.hpp"
#include "report/pixel_detail.hpp"

namespace keikan::report {

/// Everything that a page of the pixel inspector shows.
struct Page {
    std::string kind;     ///< the command of keikan-verify: scene, areas, fuzz, peers
    std::string subject;  ///< what was checked: a scene, files, families
    std::string command;  ///< repeats it
    std::string scene;    ///< the scene's file, as a word of a shell command; empty: pixel cases
    std::string size;     ///< --size, where it was given
    std::string engine;
    std::string version;  ///< of keikan
    std::uint64_t seed = 1;
    std::string summary;  ///< the JSON object of --json, which the page shows number for number
    ErrorHistogram errors;
    std::string picture;        ///< SceneLayers::json; empty: there is none
    std::string more = "null";  ///< JSON: what only this kind of page has
    std::vector<PixelToShow> pixels;
    std::uint64_t disagreeing_left_out = 0;  ///< pixels that disagree and for which there was no room
    std::vector<JunitCase> junit;
};

/// Makes the folder for a report, with the folders above it.
/// Errors: InputError naming the folder, so that it shows before hours of checking.
void make_report_folder(const std::filesystem::path& folder);

/// The page: one HTML text that needs no other file and no network. Data stand in it as JSON, with every '<'
/// escaped, so that no text of a scene or case can end their element; the page sets them as text alone.
std::string html_of(const Page& page);

/// Writes index.html, summary.json and junit.xml into `folder`; each appears whole or not at all.
/// Errors: InputError naming the file.
void write_page(const std::filesystem::path& folder, const Page& page);

}  // namespace keikan::report
