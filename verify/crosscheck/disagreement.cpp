// SPDX-License-Identifier: GPL-3.0-or-later
#include "disagreement.hpp"

#include <fmt/format.h>

namespace keikan::crosscheck {

const char* name_of(Disagreement::Kind kind) {
    switch (kind) {
        case Disagreement::Kind::Area:
            return "area";
        case Disagreement::Kind::Background:
            return "background";
        case Disagreement::Kind::Sum:
            return "sum";
        case Disagreement::Kind::Form:
            return "form";
        case Disagreement::Kind::Attributes:
            return "attributes";
        case Disagreement::Kind::Given:
            return "given";
        case Disagreement::Kind::LeftOut:
            return "left-out";
        case Disagreement::Kind::Contact:
            return "contact";
        case Disagreement::Kind::Rungs:
            return "rungs";
    }
    return "?";
}

bool is_of_areas(Disagreement::Kind kind) {
    using enum Disagreement::Kind;
    return kind == Area || kind == Background || kind == Sum || kind == LeftOut;
}

std::string text_of(const Disagreement& d) {
    std::string text = fmt::format("pixel {},{}", d.pixel.x, d.pixel.y);
    if (!d.case_id.empty()) text += fmt::format(" of case {}", d.case_id);
    text += fmt::format(": {}", name_of(d.kind));
    if (d.face) text += fmt::format(" of face {}", *d.face);
    if (is_of_areas(d.kind))
        text += fmt::format(" is {:.17g}, exactly {:.17g}: off by {:.3g}, allowed {:.3g}", d.claimed, d.exact,
                            d.error, d.bound);
    if (!d.note.empty()) text += ": " + d.note;
    return text;
}

}  // namespace keikan::crosscheck
