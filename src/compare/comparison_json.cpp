// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "keikan/compare/report.hpp"

namespace keikan::compare {

namespace {

using nlohmann::ordered_json;

ordered_json json_of(const PictureError& error) {
    return {{"pixels", error.pixels},
            {"rmse", error.rmse},
            {"largest", error.largest},
            {"off_by_more_than_1_512", error.off_share},
            {"rmse_srgb_codes", error.rmse_codes}};
}

ordered_json json_of(const MethodResult& result) {
    ordered_json json{{"method", name_of(result.method)},
                      {"seconds", result.median.wall},
                      {"processor_seconds", result.median.processor},
                      {"all", json_of(result.all)},
                      {"conductors", json_of(result.conductors)},
                      {"water_samples", result.water_samples}};
    for (const Seconds& run : result.runs) json["runs"].push_back({run.wall, run.processor});
    return json;
}

ordered_json json_of(const Trial& trial) {
    return {{"n", trial.count},
            {"conductors", json_of(trial.conductors)},
            {"seconds", trial.seconds.wall},
            {"processor_seconds", trial.seconds.processor},
            {"extrapolated", trial.extrapolated}};
}

ordered_json json_of(const EqualQuality& quality) {
    ordered_json json{{"method", name_of(quality.kind)},
                      {"goal", quality.goal == Goal::KatoRmse ? "rmse_of_kato" : "nearly_all_right"},
                      {"n", nullptr},
                      {"kato_over_method", quality.time_ratio},
                      {"last", json_of(quality.last)}};
    if (quality.reached) {
        json["n"] = quality.reached->count;
        json["at_n"] = json_of(*quality.reached);
    }
    return json;
}

ordered_json json_of(const Flicker& flicker) {
    return {{"method", name_of(flicker.method)},
            {"total_variation", flicker.total},
            {"variation", flicker.variation},
            {"light", flicker.light}};
}

}  // namespace

std::string comparison_json(const std::string& scene, const Comparison& comparison,
                            const std::optional<Sequence>& sequence) {
    ordered_json json{{"scene", scene},
                      {"size", {comparison.size.width, comparison.size.height}},
                      {"faces", comparison.faces},
                      {"threads", comparison.threads},
                      {"truth", comparison.truth_is},
                      {"conductor_pixels", comparison.conductor_pixel_count},
                      {"searched_in", comparison.has_conductors ? "conductor pixels" : "all pixels"}};
    json["methods"] = ordered_json::array();
    for (const MethodResult& result : comparison.methods) json["methods"].push_back(json_of(result));
    json["equal_quality"] = ordered_json::array();
    for (const EqualQuality& quality : comparison.equal_quality)
        json["equal_quality"].push_back(json_of(quality));
    for (const Comparison::Trials& trials : comparison.trials)
        for (const Trial& trial : trials.trials)
            json["trials"][name_of(trials.kind)].push_back(json_of(trial));
    if (sequence) {
        ordered_json& flicker = json["sequence"];
        flicker["frames"] = sequence->truth.light.size();
        flicker["conductors"] = sequence->conductors;
        flicker["exact"] = json_of(sequence->truth);
        for (const Flicker& method : sequence->methods) flicker["methods"].push_back(json_of(method));
    }
    return json.dump(2) + "\n";
}

}  // namespace keikan::compare
