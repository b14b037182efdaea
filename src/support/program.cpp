// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/program.hpp"

#include <cstdio>
#include <exception>

#include "keikan/support/input_error.hpp"

namespace keikan {

int run_program(const char* name, const std::function<int()>& body) {
    const auto told = [name](int exit_code, const std::exception& trouble) {
        std::fprintf(stderr, "%s: %s\n", name, trouble.what());
        return exit_code;
    };
    try {
        return body();
    } catch (const InputError& bad_input) {
        return told(kBadInput, bad_input);
    } catch (const std::exception& mistake) {  // a CheckFailure, or what a library throws
        return told(kCheckFailed, mistake);
    }
}

}  // namespace keikan
