// SPDX-License-Identifier: Apache-2.0
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <memory>

#include "keikan/support/check.hpp"
#include "scene_document.hpp"

namespace keikan {
namespace {

using nlohmann::json;

/// Raised whenever the same document would give other faces than before, so that older scan files are refused.
constexpr int kGeneratorVersion = 1;

/// The same number written 3, 3.0 or 3e0 makes the same faces.
json with_plain_numbers(const json& value) {
    if (value.is_number()) return value.get<double>();
    if (!value.is_structured()) return value;
    json copy = value;
    for (json& item : copy) item = with_plain_numbers(item);
    return copy;
}

json geometric_part(const json& document, ImageSize size) {
    json part = {{"version", kGeneratorVersion},
                 {"size", {size.width, size.height}},
                 {"camera", document.at("camera")},
                 {"materials", json::array()}};
    for (const char* key : {"terrain", "objects"}) {
        if (document.contains(key)) part[key] = document.at(key);
    }
    if (document.contains("materials")) {
        for (const auto& entry : document.at("materials").items()) part["materials"].push_back(entry.key());
    }
    return with_plain_numbers(part);
}

class Hash {
  public:
    Hash() : state_(XXH3_createState(), &XXH3_freeState) {
        KEIKAN_CHECK(state_ && XXH3_64bits_reset(state_.get()) == XXH_OK, "no memory for a hash");
    }
    /// Length and bytes, so that two texts after another cannot be mistaken for two others.
    void add(const std::string& bytes) {
        const std::uint64_t size = bytes.size();
        XXH3_64bits_update(state_.get(), &size, sizeof size);
        XXH3_64bits_update(state_.get(), bytes.data(), bytes.size());
    }
    std::uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

  private:
    std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

}  // namespace

std::uint64_t geometry_hash(const json& document, ImageSize size, const GeometryBlocks& blocks) {
    Hash hash;
    hash.add(geometric_part(document, size).dump());
    for (const std::filesystem::path& file : geometry_files(blocks)) hash.add(file_bytes(file.string()));
    return hash.value();
}

}  // namespace keikan
