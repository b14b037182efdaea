// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as well-known text.
#include "fuzzer.hpp"
#include "keikan/cases/wkt.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

namespace {

template <typename Read>
void read_or_refuse(Read read) {
    try {
        read();
    } catch (const InputError& error) {
        fuzzers::require(!std::string_view(error.what()).starts_with("written"), error.what());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = fuzzers::text_of(data, size);
    read_or_refuse([&] { polygons_from_wkt(text, "fuzzer"); });
    read_or_refuse([&] {
        const Ring ring = ring_from_wkt(text, "fuzzer");
        fuzzers::require(ring_from_wkt(wkt_from_ring(ring), "written") == ring, "a ring written is read");
    });
    read_or_refuse([&] {
        WktCaseReader reader(text, "fuzzer");
        while (const auto c = reader.next()) {
            const std::string written = wkt_from_case(*c);
            const auto same = WktCaseReader(written, "written").next();
            fuzzers::require(same.has_value() && wkt_from_case(*same) == written, "what is written is read");
        }
    });
    return 0;
}
