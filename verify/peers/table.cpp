// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace keikan::peers {
namespace {

/// "0" for none, so that a single pixel among millions cannot look like none.
std::string share_in_words(std::uint64_t count, std::uint64_t of) {
    if (count == 0) return "0";
    return fmt::format("{} ({:.2g} %)", count, 100 * static_cast<double>(count) / static_cast<double>(of));
}

using OrderedJson = nlohmann::ordered_json;

OrderedJson tally_in_json(const Tally& tally) {
    OrderedJson json{{"pixels", tally.pixels},
                     {"exceptions", tally.exceptions},
                     {"crashes", tally.crashes},
                     {"hangs", tally.hangs}};
    for (std::size_t i = 0; i < kWrongBy.size(); ++i) json["wrong"][kWrongByNames[i]] = tally.wrong[i];
    for (std::size_t i = 0; i < kWrongBy.size(); ++i)
        json["wrong_share"][kWrongByNames[i]] =
            tally.pixels == 0 ? 0 : static_cast<double>(tally.wrong[i]) / static_cast<double>(tally.pixels);
    json["largest_error"] = tally.largest_error;
    return json;
}

}  // namespace

double speed_of_best(const Standing& standing, std::span<const Standing> standings) {
    double best = 0;
    for (const Standing& s : standings) best = std::max(best, s.pixels_per_second());
    return best > 0 ? standing.pixels_per_second() / best : 0;
}

std::string table_in_markdown(std::span<const Standing> standings) {
    std::string text =
        "| | pixels | exceptions | crashes | hangs | wrong by > 1e-12 | > 1e-9 | > 1e-6 | > 1e-3 | largest "
        "error | "
        "pixels/s | of the best |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for (const Standing& s : standings) {
        const Tally& all = s.all;
        text += fmt::format("| {} | {} | {} | {} | {} |", s.name, all.pixels, all.exceptions, all.crashes,
                            all.hangs);
        for (const std::uint64_t wrong : all.wrong)
            text += fmt::format(" {} |", share_in_words(wrong, all.pixels));
        text += fmt::format(" {:.2g} | {:.0f} | {:.3f} |\n", all.largest_error, s.pixels_per_second(),
                            speed_of_best(s, standings));
    }
    return text;
}

std::string table_in_json(std::span<const Standing> standings) {
    OrderedJson rows = OrderedJson::array();
    for (const Standing& s : standings) {
        OrderedJson row{{"name", s.name}, {"version", s.version}};
        row.update(tally_in_json(s.all));
        row["worst"] = s.worst;
        row["not_asked"] = s.not_asked;
        row["seconds"] = s.seconds;
        row["pixels_per_second"] = s.pixels_per_second();
        row["of_best"] = speed_of_best(s, standings);
        for (const auto& [family, tally] : s.by_family) row["families"][family] = tally_in_json(tally);
        rows.push_back(std::move(row));
    }
    return rows.dump();
}

}  // namespace keikan::peers
