// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a file of pixel cases: read, or refused by an InputError; and what is read is written and read
// again as the same case.
#include <sstream>

#include "fuzzer.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/cases/svg.hpp"
#include "keikan/support/input_error.hpp"

using namespace keikan;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(fuzzers::text_of(data, size));
    PixelCaseReader reader(in, "fuzzer");
    try {
        while (const auto c = reader.next()) {
            const std::string line = pixel_case_line(*c);
            std::istringstream again(line);
            const auto same = PixelCaseReader(again, "written").next();
            fuzzers::require(same.has_value() && pixel_case_line(*same) == line, "what is written is read");
            svg_from_cases(std::span(&*c, 1));
        }
    } catch (const InputError& error) {
        fuzzers::require(!std::string_view(error.what()).starts_with("written"), error.what());
    }
    return 0;
}
