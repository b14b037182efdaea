// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/scene_layers.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "keikan/support/parallel.hpp"
#include "report/packed_bytes.hpp"

namespace keikan::report {
namespace {

using Json = nlohmann::ordered_json;
using crosscheck::ClaimedRow;

constexpr std::uint16_t kNoObject = 0xFFFF, kSeveralObjects = 0xFFFE;

/// Each value less the one to its left, so that smooth pictures become small numbers.
std::vector<std::uint16_t> differences(const Image<std::uint16_t>& values) {
    std::vector<std::uint16_t> result;
    result.reserve(values.values().size());
    for (int y = 0; y < values.height(); ++y) {
        std::uint16_t left = 0;
        for (const std::uint16_t value : values.row(y)) {
            result.push_back(static_cast<std::uint16_t>(value - left));
            left = value;
        }
    }
    return result;
}

template <float Rgb::*channel>
std::string packed_channel(const Image<Rgb>& picture) {
    Image<std::uint16_t> halves(picture.size());
    std::ranges::transform(picture.values(), halves.values().begin(),
                           [](const Rgb& colour) { return half_float(colour.*channel); });
    return packed_planes(differences(halves));
}

/// 0: one face, 1: exact areas, 2: along the scanline; 128 more where something disagrees.
std::string packed_flags(const crosscheck::SceneCheck& check) {
    std::vector<std::uint8_t> flags;
    for (std::size_t i = 0; i < check.flags().values().size(); ++i)
        flags.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(check.flags().values()[i]) |
                                                  (check.wrong().values()[i] != 0 ? 128u : 0u)));
    return packed(flags);
}

/// How much of a pixel several objects show, by rising pixel.
struct Coverages {
    Image<std::uint16_t> only;          ///< the object that alone is seen, kNoObject, or kSeveralObjects
    std::vector<std::uint32_t> pixels;  ///< of each share: pixels passed since the share before
    std::vector<std::uint16_t> objects;
    std::vector<float> shares;
};

}  // namespace

SceneLayers::SceneLayers(const ProjectedFaces& faces, const Geometry& geometry, ImageSize size)
    : faces_(faces), geometry_(geometry), size_(size), rows_(static_cast<std::size_t>(size.height)) {}

void SceneLayers::take(const ScanBand& band) {
    parallel_for(static_cast<std::size_t>(band.rows), [&](std::size_t i) {
        const int y = band.first_row + static_cast<int>(i);
        rows_[static_cast<std::size_t>(y)] = crosscheck::claimed_row(band, y, size_.width, faces_);
    });
}

std::uint16_t SceneLayers::object_index(std::uint32_t face) const {
    const auto next = std::ranges::upper_bound(geometry_.first_face, faces_.id[face]);
    return static_cast<std::uint16_t>(next - geometry_.first_face.begin() - 1);
}

const std::string& SceneLayers::object_of(std::uint32_t face) const {
    return geometry_.objects[object_index(face)].name;
}

std::string SceneLayers::json(const Image<Rgb>& picture, const crosscheck::SceneCheck& check) const {
    Coverages seen{.only = Image<std::uint16_t>(size_, kNoObject), .pixels = {}, .objects = {}, .shares = {}};
    std::vector<std::pair<std::uint16_t, double>> here;
    std::uint32_t index = 0, last = 0;
    for (int y = 0; y < size_.height; ++y)
        for (int x = 0; x < size_.width; ++x, ++index) {
            const ClaimedRow& row = rows_[static_cast<std::size_t>(y)];
            const ClaimedRow::Pixel& pixel = row.pixels[static_cast<std::size_t>(x)];
            here.clear();
            for (const ClaimedRow::Part& part : row.parts_of(pixel)) {
                const std::uint16_t object = object_index(part.face);
                const auto at = std::ranges::find(here, object, &std::pair<std::uint16_t, double>::first);
                if (at == here.end())
                    here.emplace_back(object, part.area);
                else
                    at->second += part.area;
            }
            if (here.empty()) continue;
            if (here.size() == 1 && pixel.background == 0) {
                seen.only[{x, y}] = here[0].first;
                continue;
            }
            seen.only[{x, y}] = kSeveralObjects;
            for (const auto& [object, share] : here) {
                seen.pixels.push_back(index - std::exchange(last, index));
                seen.objects.push_back(object);
                seen.shares.push_back(static_cast<float>(share));
            }
        }
    Json json{{"width", size_.width}, {"height", size_.height}, {"objects", Json::array()}};
    for (const Object& object : geometry_.objects) json["objects"].push_back(object.name);
    json["layers"] = {{"red", packed_channel<&Rgb::r>(picture)},
                      {"green", packed_channel<&Rgb::g>(picture)},
                      {"blue", packed_channel<&Rgb::b>(picture)},
                      {"errors", packed_planes(check.errors().values())},
                      {"flags", packed_flags(check)},
                      {"faces", packed_planes(check.faces().values())},
                      {"asked", packed_planes(check.asked().values())},
                      {"kinds", packed(check.kinds().values())},
                      {"object", packed_planes(std::as_const(seen.only).values())},
                      {"share_pixels", packed_planes(seen.pixels)},
                      {"share_objects", packed_planes(seen.objects)},
                      {"shares", packed_planes(seen.shares)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace keikan::report
