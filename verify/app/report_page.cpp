// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_page.hpp"

namespace keikan {

report::Page page_of(const std::string& kind, const CommonOptions& common) {
    report::Page page;
    page.kind = kind;
    page.command = common.command_line;
    page.version = KEIKAN_VERSION;
    page.seed = common.seed;
    return page;
}

}  // namespace keikan
