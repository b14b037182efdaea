// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace keikan::crosscheck {
namespace {

using Json = nlohmann::ordered_json;

void keep_worst(std::vector<WorstPixel>& worst) {
    std::ranges::stable_sort(worst, std::ranges::greater{}, &WorstPixel::error);
    if (worst.size() > CheckSummary::kWorstKept) worst.resize(CheckSummary::kWorstKept);
}

/// JSON has no infinity: an error without measure is written as the largest double.
double finite(double value) {
    return std::isfinite(value) ? value : std::numeric_limits<double>::max();
}

Json pixel_json(PixelIndex pixel) {
    return Json::array({pixel.x, pixel.y});
}

Json disagreement_json(const Disagreement& d) {
    Json json{{"kind", name_of(d.kind)}, {"pixel", pixel_json(d.pixel)}};
    if (!d.case_id.empty()) json["id"] = d.case_id;
    if (d.face) json["face"] = *d.face;
    json["claimed"] = finite(d.claimed);
    json["exact"] = d.exact;
    json["error"] = finite(d.error);
    json["bound"] = d.bound;
    if (!d.note.empty()) json["note"] = d.note;
    return json;
}

}  // namespace

double UnflaggedErrors::rmse() const {
    return pixels == 0 ? 0 : std::sqrt(sum_of_squares / static_cast<double>(pixels));
}

void UnflaggedErrors::add(double error) {
    ++pixels;
    visibly_wrong += error > 1.0 / 512;
    sum_of_squares += error * error;
    max_error = std::max(max_error, error);
}

UnflaggedErrors& UnflaggedErrors::operator+=(const UnflaggedErrors& other) {
    pixels += other.pixels;
    visibly_wrong += other.visibly_wrong;
    sum_of_squares += other.sum_of_squares;
    max_error = std::max(max_error, other.max_error);
    return *this;
}

void CheckSummary::add(const PixelVerdict& verdict, PixelIndex pixel, const std::string& case_id,
                       std::size_t faces) {
    ++pixels;
    polygons += faces;
    max_area_error = std::max(max_area_error, verdict.area_error);
    if (verdict.faces <= 8)
        max_area_error_to_8_faces = std::max(max_area_error_to_8_faces, verdict.area_error);
    max_sum_error = std::max(max_sum_error, verdict.sum_error);
    rungs += verdict.rungs;
    contacts += verdict.contacts;
    const double error = std::max(verdict.area_error, verdict.sum_error);
    if (worst.size() < kWorstKept || error > worst.back().error) {
        worst.push_back({pixel, case_id, error});
        keep_worst(worst);
    }
    for (const Disagreement& d : verdict.disagreements) add(d);
}

void CheckSummary::add(const Disagreement& disagreement) {
    ++disagreement_count;
    if (disagreements.size() < kDisagreementsKept) disagreements.push_back(disagreement);
}

CheckSummary& CheckSummary::operator+=(const CheckSummary& later) {
    pixels += later.pixels;
    polygons += later.polygons;
    max_area_error = std::max(max_area_error, later.max_area_error);
    max_area_error_to_8_faces = std::max(max_area_error_to_8_faces, later.max_area_error_to_8_faces);
    max_sum_error = std::max(max_sum_error, later.max_sum_error);
    rungs += later.rungs;
    contacts += later.contacts;
    worst.insert(worst.end(), later.worst.begin(), later.worst.end());
    keep_worst(worst);
    for (const Disagreement& d : later.disagreements)
        if (disagreements.size() < kDisagreementsKept) disagreements.push_back(d);
    disagreement_count += later.disagreement_count;
    return *this;
}

std::string summary_json(const CheckSummary& summary, const UnflaggedErrors* unflagged) {
    Json json{{"verdict", summary.pass() ? "pass" : "fail"},
              {"pixels", summary.pixels},
              {"polygons", summary.polygons},
              {"max_area_error", finite(summary.max_area_error)},
              {"max_area_error_to_8_faces", finite(summary.max_area_error_to_8_faces)},
              {"max_sum_error", finite(summary.max_sum_error)},
              {"classification",
               {{"checked", summary.contacts.checked},
                {"mismatches", summary.contacts.mismatches},
                {"folds", summary.contacts.folds},
                {"steps_by_cgal", summary.contacts.constructed}}},
              {"oracle",
               {{"cgal", summary.rungs.cgal},
                {"rational", summary.rungs.rational},
                {"quad", summary.rungs.quad},
                {"certified", summary.rungs.certified}}},
              {"worst", Json::array()},
              {"disagreement_count", summary.disagreement_count},
              {"disagreements", Json::array()}};
    for (const WorstPixel& w : summary.worst) {
        Json worst{{"pixel", pixel_json(w.pixel)}, {"error", finite(w.error)}};
        if (!w.case_id.empty()) worst["id"] = w.case_id;
        json["worst"].push_back(worst);
    }
    for (const Disagreement& d : summary.disagreements) json["disagreements"].push_back(disagreement_json(d));
    if (unflagged)
        json["unflagged"] = {{"pixels", unflagged->pixels},
                             {"visibly_wrong", unflagged->visibly_wrong},
                             {"rmse", unflagged->rmse()},
                             {"max_error", unflagged->max_error}};
    if (summary.left_out)
        json["left_out"] = {{"faces", summary.left_out->faces},
                            {"pixels", summary.left_out->pixels},
                            {"largest_seen", summary.left_out->largest}};
    json["seconds"] = summary.seconds;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace keikan::crosscheck
