// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace keikan::report {

/// The page without its data, made of verify/report/page by bundle_page.py when the program is built. Its one
/// line "<!--data-->" stands where the data belong.
extern const std::string_view kPageTemplate;

}  // namespace keikan::report
