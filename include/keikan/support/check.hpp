// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>

namespace keikan {

/// Our own mistake, found by KEIKAN_CHECK. `main` prints it, with where it happened, and exits with 1.
class CheckFailure : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

[[noreturn]] void check_failed(const char* file, int line, const char* condition, const std::string& message);

}  // namespace keikan

/// Stops with a CheckFailure unless `condition` holds, in every build. The message is streamed:
/// KEIKAN_CHECK(n > 0, "row " << row << " has no pixels").
#define KEIKAN_CHECK(condition, message)                                                  \
    do {                                                                                  \
        if (!(condition)) [[unlikely]] {                                                  \
            std::ostringstream keikan_message;                                            \
            keikan_message << message;                                                    \
            ::keikan::check_failed(__FILE__, __LINE__, #condition, keikan_message.str()); \
        }                                                                                 \
    } while (false)

/// The same for inner loops: only in debug builds.
#ifdef KEIKAN_DEBUG_CHECKS
#define KEIKAN_DCHECK(condition, message) KEIKAN_CHECK(condition, message)
#else
#define KEIKAN_DCHECK(condition, message) ((void)0)
#endif
