// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as GeoJSON.
#include "fuzzer.hpp"
#include "keikan/cases/geojson.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = fuzzers::text_of(data, size);
    try {
        polygons_from_geojson(text, "fuzzer");
    } catch (const InputError&) {
    }
    try {
        GeoJsonCaseReader reader(text, "fuzzer");
        while (const auto c = reader.next()) {
            const std::string written = geojson_from_case(*c);
            const auto same = GeoJsonCaseReader(written, "written").next();
            fuzzers::require(same.has_value() && geojson_from_case(*same) == written,
                             "what is written is read");
        }
    } catch (const InputError& error) {
        fuzzers::require(!std::string_view(error.what()).starts_with("written"), error.what());
    }
    return 0;
}
