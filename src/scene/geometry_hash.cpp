// SPDX-License-Identifier: Apache-2.0
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <memory>

#include "keikan/support/check.hpp"
#include "scene_document.hpp"

namespace keikan {
namespace {

using nlohmann::json;

/// Raised whenever the same document would give other faces than before, so that older scan files are
/// refused.
constexpr int kGeneratorVersion = 1;

void append_bytes(std::string& text, const void* bytes, std::size_t size) {
    text.append(static_cast<const char*>(bytes), size);
}

/// Length and bytes, so that two texts after another cannot be mistaken for two others.
void append_text(std::string& canonical, const std::string& text) {
    const std::uint64_t size = text.size();
    append_bytes(canonical, &size, sizeof size);
    canonical += text;
}

/// Of water, "surface" changes no face.
bool is_geometric(const json& value, const std::string& key) {
    return key != "surface" || value.value("type", json()) != "water";
}

/// A value in one form only: keys sorted (as nlohmann keeps them), and numbers as doubles, so that 3, 3.0 and
/// 3e0 are the same.
void append_value(std::string& canonical, const json& value) {
    canonical += static_cast<char>(value.is_number() ? json::value_t::number_float : value.type());
    if (value.is_number()) {
        const double number = value.get<double>() + 0.0;  // -0 is 0
        append_bytes(canonical, &number, sizeof number);
    } else if (value.is_string()) {
        append_text(canonical, value.get_ref<const std::string&>());
    } else if (value.is_boolean()) {
        canonical += value.get<bool>() ? '1' : '0';
    } else if (value.is_structured()) {
        std::uint64_t size = value.size();
        if (value.is_object() && value.contains("surface") && !is_geometric(value, "surface")) --size;
        append_bytes(canonical, &size, sizeof size);
        for (auto item = value.begin(); item != value.end(); ++item) {
            if (value.is_object() && !is_geometric(value, item.key())) continue;
            if (value.is_object()) append_text(canonical, item.key());
            append_value(canonical, *item);
        }
    }
}

std::string geometric_part(const json& document, ImageSize size) {
    std::string canonical;
    for (const int number : {kGeneratorVersion, size.width, size.height}) {
        append_bytes(canonical, &number, sizeof number);
    }
    for (const char* key : {"camera", "terrain", "objects"}) {
        const auto found = document.find(key);
        canonical += found == document.end() ? '0' : '1';
        if (found != document.end()) append_value(canonical, *found);
    }
    if (document.contains("materials")) {
        for (const auto& entry : document.at("materials").items()) append_text(canonical, entry.key());
    }
    return canonical;
}

class Hash {
  public:
    Hash() : state_(XXH3_createState(), &XXH3_freeState) {
        KEIKAN_CHECK(state_ && XXH3_64bits_reset(state_.get()) == XXH_OK, "no memory for a hash");
    }
    /// Length and bytes, as append_text.
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
    hash.add(geometric_part(document, size));
    for (const std::filesystem::path& file : geometry_files(blocks)) hash.add(file_bytes(file.string()));
    return hash.value();
}

}  // namespace keikan
