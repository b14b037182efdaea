// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/peer.hpp"

namespace keikan::peers {

std::optional<Peer> boost_geometry_1_81() {
    return std::nullopt;  // the build did not find its headers
}

}  // namespace keikan::peers
