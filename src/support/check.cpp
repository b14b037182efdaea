// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/check.hpp"

#include <string_view>

namespace keikan {

void check_failed(const char* file, int line, const char* condition, const std::string& message) {
    const std::string_view path = file;
    const std::string name(path.substr(path.find_last_of('/') + 1));
    throw CheckFailure(name + ":" + std::to_string(line) + ": " + message + " (" + condition + ")");
}

}  // namespace keikan
