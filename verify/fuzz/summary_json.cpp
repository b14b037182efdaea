// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/summary_json.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

namespace keikan::fuzz {
namespace {

using crosscheck::CheckSummary;
using crosscheck::Disagreement;
using crosscheck::WorstPixel;
using Json = nlohmann::json;

/// Hexadecimal: errors may be infinite or no number, for which JSON has no word.
Json exactly(double value) {
    return fmt::format("{:a}", value);
}
double exactly(const Json& text) {
    return std::strtod(text.get_ref<const std::string&>().c_str(), nullptr);
}

Json json_of(const Disagreement& d) {
    Json json{{"kind", static_cast<int>(d.kind)},
              {"pixel", {d.pixel.x, d.pixel.y}},
              {"id", d.case_id},
              {"claimed", exactly(d.claimed)},
              {"exact", exactly(d.exact)},
              {"error", exactly(d.error)},
              {"bound", exactly(d.bound)},
              {"note", d.note}};
    if (d.face) json["face"] = *d.face;
    return json;
}

Disagreement disagreement_of(const Json& json) {
    Disagreement d{.kind = static_cast<Disagreement::Kind>(json.at("kind").get<int>()),
                   .pixel = {json.at("pixel").at(0), json.at("pixel").at(1)},
                   .case_id = json.at("id"),
                   .face = {},
                   .claimed = exactly(json.at("claimed")),
                   .exact = exactly(json.at("exact")),
                   .error = exactly(json.at("error")),
                   .bound = exactly(json.at("bound")),
                   .note = json.at("note")};
    if (json.contains("face")) d.face = json["face"].get<FaceId>();
    return d;
}

}  // namespace

Json json_of(const CheckSummary& s) {
    Json json{
        {"pixels", s.pixels},
        {"polygons", s.polygons},
        {"max_area_error", exactly(s.max_area_error)},
        {"max_area_error_to_8_faces", exactly(s.max_area_error_to_8_faces)},
        {"max_sum_error", exactly(s.max_sum_error)},
        {"rungs", {s.rungs.quad, s.rungs.certified, s.rungs.rational, s.rungs.cgal}},
        {"contacts", {s.contacts.checked, s.contacts.mismatches, s.contacts.folds, s.contacts.constructed}},
        {"worst", Json::array()},
        {"disagreement_count", s.disagreement_count},
        {"disagreements", Json::array()}};
    for (const WorstPixel& w : s.worst)
        json["worst"].push_back(
            {{"pixel", {w.pixel.x, w.pixel.y}}, {"id", w.case_id}, {"error", exactly(w.error)}});
    for (const Disagreement& d : s.disagreements) json["disagreements"].push_back(json_of(d));
    return json;
}

CheckSummary summary_of(const Json& json) {
    CheckSummary s;
    s.pixels = json.at("pixels");
    s.polygons = json.at("polygons");
    s.max_area_error = exactly(json.at("max_area_error"));
    s.max_area_error_to_8_faces = exactly(json.at("max_area_error_to_8_faces"));
    s.max_sum_error = exactly(json.at("max_sum_error"));
    const Json& rungs = json.at("rungs");
    s.rungs = {rungs.at(0), rungs.at(1), rungs.at(2), rungs.at(3)};
    const Json& contacts = json.at("contacts");
    s.contacts = {contacts.at(0), contacts.at(1), contacts.at(2), contacts.at(3)};
    for (const Json& w : json.at("worst"))
        s.worst.push_back({{w.at("pixel").at(0), w.at("pixel").at(1)}, w.at("id"), exactly(w.at("error"))});
    s.disagreement_count = json.at("disagreement_count");
    for (const Json& d : json.at("disagreements")) s.disagreements.push_back(disagreement_of(d));
    return s;
}

}  // namespace keikan::fuzz
