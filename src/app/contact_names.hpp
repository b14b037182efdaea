// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "keikan/model/contact.hpp"

namespace keikan {

// The words of the commands' answers.

constexpr const char* name_of(ContactClass kind) {
    switch (kind) {
        case ContactClass::EdgeEdge:
            return "edge-edge";
        case ContactClass::SubjectVertex:
            return "subject-vertex";
        case ContactClass::ClipVertex:
            return "clip-vertex";
        case ContactClass::SharedVertex:
            return "shared-vertex";
    }
    return "";
}

constexpr const char* name_of(Turn turn) {
    switch (turn) {
        case Turn::Enter:
            return "enter";
        case Turn::Leave:
            return "leave";
        case Turn::Touch:
            return "touch";
    }
    return "";
}

}  // namespace keikan
