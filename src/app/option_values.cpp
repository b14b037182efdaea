// SPDX-License-Identifier: Apache-2.0
#include "option_values.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <utility>

#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

/// Two whole numbers with `between` between them and nothing else.
std::optional<std::pair<int, int>> two_numbers(const std::string& text, char between) {
    int first = 0, second = 0;
    const char* const end = text.data() + text.size();
    const auto one = std::from_chars(text.data(), end, first);
    if (one.ec != std::errc() || one.ptr == end || *one.ptr != between) return std::nullopt;
    const auto two = std::from_chars(one.ptr + 1, end, second);
    if (two.ec != std::errc() || two.ptr != end) return std::nullopt;
    return std::pair(first, second);
}

}  // namespace

std::optional<ImageSize> picture_size(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const auto numbers = two_numbers(text, 'x');
    if (!numbers) throw InputError("--size: '" + text + "' is not WIDTHxHEIGHT, such as 1000x650");
    const auto [width, height] = *numbers;
    constexpr std::int64_t kMaxPixels = 1 << 28;
    if (width < 1 || height < 1 || std::int64_t{width} * height > kMaxPixels)
        throw InputError("--size: a picture of " + text + " pixels cannot be made");
    return ImageSize{width, height};
}

PixelIndex pixel_of(const std::string& text, ImageSize size, const std::string& option) {
    const auto numbers = two_numbers(text, ',');
    if (!numbers) throw InputError(option + ": '" + text + "' is not X,Y, such as 412,77");
    const auto [x, y] = *numbers;
    if (x < 0 || y < 0 || x >= size.width || y >= size.height)
        throw InputError(option + ": pixel " + text + " is outside of the picture of " +
                         std::to_string(size.width) + "x" + std::to_string(size.height));
    return {x, y};
}

void add_shadows_option(CLI::App& app, std::string& shadows) {
    app.add_option("--shadows", shadows,
                   "Of the sun on faces: off, hard (a point), soft (its disc) (default: as the scene says)");
}

std::optional<Shadows> shadows_of(const std::string& text) {
    if (text.empty()) return std::nullopt;
    if (text == "off") return Shadows::Off;
    if (text == "hard") return Shadows::Hard;
    if (text == "soft") return Shadows::Soft;
    throw InputError("--shadows: '" + text + "' is none of off, hard, soft");
}

Extraction extraction_of(const std::string& text) {
    if (text == "outline") return Extraction::Outline;
    if (text == "paper") return Extraction::Paper;
    throw InputError("--extract: '" + text + "' is neither 'outline' nor 'paper'");
}

Engine engine_of(const std::string& engine) {
    if (engine == "splitting") return Engine::Splitting;
    if (engine == "traversal") return Engine::Traversal;
    if (engine == "published") return Engine::Published;
    throw InputError("--engine " + engine + ": there are only: splitting, traversal, published");
}

Engine engine_of_scan_file(const std::string& text) {
    const Engine engine = engine_of(text);
    if (engine == Engine::Published)
        throw InputError(
            "--engine published: a scan file promises areas that add up to 1; "
            "render and areas take this engine");
    return engine;
}

}  // namespace keikan
