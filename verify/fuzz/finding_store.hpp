// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

#include "fuzz/finding.hpp"

namespace keikan::fuzz {

/// A folder of shrunk findings, each in four files that bear its name: NAME.wkt, NAME.geojson and NAME.svg
/// for other programs and for the eye, and last NAME.jsonl, the pixel case. Each file appears whole or not at
/// all; content that is there already is left as it is.
class FindingStore {
  public:
    /// Makes the folder where it is missing. Errors: InputError naming it.
    FindingStore(std::filesystem::path folder, std::string version);

    /// Requires: `finding.shrunk`. Errors: InputError naming a file that cannot be written.
    void keep(const Finding& finding) const;

  private:
    std::filesystem::path folder_;
    std::string version_;
};

}  // namespace keikan::fuzz
