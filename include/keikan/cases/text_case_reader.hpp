// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "keikan/model/pixel_case.hpp"

namespace keikan {

/// Pixel cases in a text that is in memory as a whole, one after the other; each `Format` says what one is
/// (wkt.hpp, geojson.hpp).
template <typename Format>
class TextCaseReader {
  public:
    /// `text` must outlive the reader; `name` stands for it in messages.
    TextCaseReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    /// Errors: InputError, as the format's header says.
    std::optional<PixelCase> next();

  private:
    std::string_view text_;
    std::string name_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;  ///< of `at_`
};

}  // namespace keikan
