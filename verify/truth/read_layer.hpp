// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "layer_truth.hpp"

namespace keikan::truth {

/// Files of polygons as layers, nearest first: well-known text (.wkt), GeoJSON (.geojson, .json). A layer is
/// named after its file, without folder and ending, or, where two would have the same name, as it was given.
/// Errors: InputError naming the file: another ending, what cannot be read, what the readers refuse
/// (keikan/cases/wkt.hpp, keikan/cases/geojson.hpp).
std::vector<Layer> read_layers(const std::vector<std::string>& files);

/// A number that two lists of layers share only if they are the same list (64-bit hash of names and
/// coordinates).
std::uint64_t hash_of(const std::vector<Layer>& layers);

}  // namespace keikan::truth
