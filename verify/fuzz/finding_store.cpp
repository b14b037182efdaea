// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/finding_store.hpp"

#include <fmt/format.h>

#include <span>
#include <system_error>
#include <utility>

#include "keikan/cases/geojson.hpp"
#include "keikan/cases/svg.hpp"
#include "keikan/cases/wkt.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan::fuzz {

FindingStore::FindingStore(std::filesystem::path folder, std::string version)
    : folder_(std::move(folder)), version_(std::move(version)) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw InputError(folder_.string(), "", "cannot be made: " + error.message());
}

void FindingStore::keep(const Finding& finding) const {
    const PixelCase& shrunk = *finding.shrunk;
    const auto file = [&](const char* ending) { return folder_ / (shrunk.id + ending); };
    if (std::filesystem::exists(file(".jsonl"))) return;
    write_whole_file(file(".wkt"), wkt_from_case(shrunk) + "\n");
    write_whole_file(file(".geojson"), geojson_from_case(shrunk) + "\n");
    write_whole_file(file(".svg"), svg_from_cases(std::span(&shrunk, 1)));
    write_whole_file(file(".jsonl"), shrunk_line(finding, version_) + "\n");
}

}  // namespace keikan::fuzz
