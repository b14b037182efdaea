// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/finding.hpp"

#include <CGAL/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "keikan/cases/pixel_case_file.hpp"
#include "oracle/exact_areas.hpp"

namespace keikan::fuzz {
namespace {

using crosscheck::Disagreement;
using OrderedJson = nlohmann::ordered_json;

/// Fractions of denormal numbers have thousands of digits; an answer longer than this is left out.
constexpr std::size_t kLongestAnswer = 400;

Disagreement::Kind group_of(Disagreement::Kind kind) {
    return kind == Disagreement::Kind::Background ? Disagreement::Kind::Area : kind;
}

std::string line_of(const Finding& finding, const PixelCase& pixel_case, const std::string& why,
                    const std::string& version) {
    const Disagreement& d = finding.disagreement;
    const double error = std::isfinite(d.error) ? d.error : std::numeric_limits<double>::max();
    const OrderedJson found{
        {"as", finding.as_found.id},
        {"seed", finding.seed},
        {"family", finding.family},
        {"engine", finding.engine},
        {"kind", crosscheck::name_of(d.kind)},
        {"error", error},
        {"versions", {{"keikan", version}, {"cgal", CGAL_VERSION_STR}, {"compiler", __VERSION__}}}};
    const auto text = [](const OrderedJson& json) {
        return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    };
    std::string line = pixel_case_line(pixel_case);
    line.pop_back();
    return line + fmt::format(", \"why\": {}, \"found\": {}}}", text(why), text(found));
}

}  // namespace

std::optional<Symptom> symptom_of(std::span<const Disagreement> disagreements) {
    if (disagreements.empty()) return std::nullopt;
    Symptom symptom{group_of(disagreements[0].kind), true};
    symptom.gross = find_symptom(disagreements, symptom) != nullptr;
    return symptom;
}

const Disagreement* find_symptom(std::span<const Disagreement> disagreements, const Symptom& symptom) {
    for (const Disagreement& d : disagreements)
        if (group_of(d.kind) == symptom.kind && (!symptom.gross || d.error > kGrossError)) return &d;
    return nullptr;
}

std::string name_of_finding(const PixelCase& smallest, const std::string& family, const std::string& engine) {
    PixelCase content = smallest;
    content.id = engine;
    content.areas.reset();
    content.background.reset();
    const std::string text = pixel_case_line(content);
    return fmt::format("{}-{:016x}", family, XXH3_64bits(text.data(), text.size()));
}

void state_answers(PixelCase& pixel_case) {
    const auto exact =
        oracle::areas_by_rational_splitting(pixel_case.pixel, pixel_case.faces(), pixel_case.nearness());
    std::vector<std::string> areas;
    std::size_t longest = 0;
    for (const mpq_class& area : exact.areas)
        longest = std::max(longest, areas.emplace_back(area.get_str()).size());
    if (longest > kLongestAnswer) return;
    pixel_case.areas = std::move(areas);
    pixel_case.background = exact.background.get_str();
}

std::string shrunk_line(const Finding& finding, const std::string& version) {
    return line_of(finding, *finding.shrunk, finding.why, version);
}

std::string as_found_line(const Finding& finding, const std::string& version) {
    return line_of(finding, finding.as_found, crosscheck::text_of(finding.disagreement), version);
}

}  // namespace keikan::fuzz
