// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_layer.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "keikan/cases/geojson.hpp"
#include "keikan/cases/wkt.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan::truth {
namespace {

std::string contents(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open() || in.bad()) throw InputError(file, "", "cannot be read");
    return text;
}

std::vector<Polygon> polygons_of(const std::string& file) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending == ".wkt") return polygons_from_wkt(contents(file), file);
    if (ending == ".geojson" || ending == ".json") return polygons_from_geojson(contents(file), file);
    throw InputError(file, "", "a layer's file ends in .wkt, .geojson or .json");
}

/// Lengths before contents, so that no two lists write the same bytes.
class Bytes {
  public:
    void add(const std::string& text) {
        add(static_cast<std::uint64_t>(text.size()));
        bytes_ += text;
    }
    void add(const Ring& ring) {
        add(static_cast<std::uint64_t>(ring.size()));
        for (const Point p : ring) add(p.x), add(p.y);
    }
    template <typename Number>
    void add(Number value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes_.append(raw, sizeof value);
    }
    std::uint64_t hash() const { return XXH3_64bits(bytes_.data(), bytes_.size()); }

  private:
    std::string bytes_;
};

}  // namespace

std::vector<Layer> read_layers(const std::vector<std::string>& files) {
    std::vector<Layer> layers;
    std::multiset<std::string> stems;
    for (const std::string& file : files) stems.insert(std::filesystem::path(file).stem().string());
    for (const std::string& file : files) {
        const std::string stem = std::filesystem::path(file).stem().string();
        layers.push_back({stems.count(stem) == 1 ? stem : file, polygons_of(file)});
    }
    return layers;
}

std::uint64_t hash_of(const std::vector<Layer>& layers) {
    Bytes bytes;
    for (const Layer& layer : layers) {
        bytes.add(layer.name);
        bytes.add(static_cast<std::uint64_t>(layer.polygons.size()));
        for (const Polygon& polygon : layer.polygons) {
            bytes.add(polygon.outline);
            bytes.add(static_cast<std::uint64_t>(polygon.holes.size()));
            for (const Ring& hole : polygon.holes) bytes.add(hole);
        }
    }
    return bytes.hash();
}

}  // namespace keikan::truth
