// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <istream>
#include <optional>
#include <string>

#include "keikan/model/pixel_case.hpp"

namespace keikan {

/// Reads pixel cases (JSON Lines, docs/cases.md) one at a time, so that a file may be of any length.
/// Coordinates are JSON numbers or strings with a C hexadecimal float; each is exactly the double it names.
///
/// Errors: InputError naming file, line and reason: broken JSON, a number that is not finite, a polygon
///         that is not convex (exactly: by the sign of orient2d on the doubles given), `depth` of another
///         length than `polygons`. Empty lines are skipped; unknown keys are ignored.
class PixelCaseReader {
  public:
    /// `name` stands for the stream in messages.
    PixelCaseReader(std::istream& in, std::string name);
    /// The next case, or nothing at the end. Its id defaults to the line number.
    std::optional<PixelCase> next();

  private:
    std::istream& in_;
    std::string name_;
    long line_ = 0;
};

/// The case as one line of JSON without its line end. Every coordinate is written as a decimal number
/// with 17 significant digits, which names the same double again.
std::string pixel_case_line(const PixelCase& pixel_case);

}  // namespace keikan
