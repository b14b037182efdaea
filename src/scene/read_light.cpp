// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "degree.hpp"
#include "keikan/scene/sun_position.hpp"
#include "scene_blocks.hpp"

namespace keikan {
namespace {

/// The numbers of a text such as "1997-10-15" or "10:30:00", which must look exactly like `pattern`, where
/// '0' stands for a digit. Nothing where it does not.
std::optional<std::vector<int>> numbers_like(const std::string& text, const std::string& pattern) {
    if (text.size() != pattern.size()) return std::nullopt;
    std::vector<int> numbers{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (pattern[i] == '0') {
            if (text[i] < '0' || text[i] > '9') return std::nullopt;
            numbers.back() = 10 * numbers.back() + (text[i] - '0');
        } else {
            if (text[i] != pattern[i]) return std::nullopt;
            numbers.push_back(0);
        }
    }
    return numbers;
}

void read_date(const JsonNode& node, ClockTime& time) {
    const auto numbers = numbers_like(node.text(), "0000-00-00");
    if (!numbers) node.fail("must look like \"1997-10-15\"");
    time.year = (*numbers)[0];
    time.month = (*numbers)[1];
    time.day = (*numbers)[2];
    const std::chrono::year_month_day date{std::chrono::year{time.year},
                                           std::chrono::month{static_cast<unsigned>(time.month)},
                                           std::chrono::day{static_cast<unsigned>(time.day)}};
    if (!date.ok()) node.fail("is not a day of the calendar");
    if (time.year < 1950 || time.year > 2050)
        node.fail("must be from 1950 to 2050, where the sun's series holds");
}

void read_time(const JsonNode& node, ClockTime& time) {
    const std::string text = node.text();
    auto numbers = numbers_like(text, "00:00:00");
    if (!numbers) numbers = numbers_like(text, "00:00");
    if (!numbers) node.fail("must look like \"10:30\" or \"10:30:00\"");
    numbers->resize(3, 0);
    if ((*numbers)[0] > 23 || (*numbers)[1] > 59 || (*numbers)[2] > 59) node.fail("is not a time of the day");
    time.hour = (*numbers)[0];
    time.minute = (*numbers)[1];
    time.second = (*numbers)[2];
}

glm::dvec3 sun_by_date(JsonObject& object) {
    ClockTime time;
    read_date(object.required("date"), time);
    read_time(object.required("time"), time);
    time.utc_offset_hours = object.required("utc_offset_hours").number(between(-14, 14));
    const double latitude = object.required("latitude_deg").number(between(-90, 90));
    const double longitude = object.required("longitude_deg").number(between(-180, 180));
    const SunPosition sun = sun_position(time, latitude, longitude);
    if (sun.elevation_rad < 0) {
        object.fail(
            fmt::format("the sun is {:.2f} degrees below the horizon then", -sun.elevation_rad / kDegree));
    }
    return direction_of(sun);
}

glm::dvec3 to_sun(JsonObject& object) {
    const std::string key = object.exactly_one_of({"direction", "azimuth_deg", "date"});
    if (key == "date") return sun_by_date(object);
    if (key == "azimuth_deg") {
        const double azimuth = object.required("azimuth_deg").number(between(-360, 360));
        const double elevation = object.required("elevation_deg").number(between(-90, 90));
        return direction_of({azimuth * kDegree, elevation * kDegree});
    }
    const JsonNode node = object.required("direction");
    const glm::dvec3 direction = node.triple();
    const double length = glm::length(direction);
    if (!(length > 0) || !std::isfinite(length)) node.fail("must have a length");
    return direction / length;
}

HeightSlopeRamp read_ramp(const JsonNode& node) {
    JsonObject object(node);
    HeightSlopeRamp ramp;
    const JsonNode stops = object.required("stops");
    for (std::size_t i = 0; i < stops.array_size(1, 256); ++i) {
        JsonObject stop(stops.item(i));
        const JsonNode height = stop.required("height_m");
        ramp.stops.push_back(
            {static_cast<float>(height.number(between(-20000, 20000))), stop.required("colour").colour()});
        stop.no_other_keys();
        if (i > 0 && ramp.stops[i].height_m <= ramp.stops[i - 1].height_m) {
            height.fail("must be greater than the height of the stop before");
        }
    }
    ramp.steep = object.colour_or("steep", ramp.steep);
    ramp.steep_from_deg = static_cast<float>(object.number_or("steep_from_deg", 35, between(0, 90)));
    ramp.steep_full_deg = static_cast<float>(object.number_or(
        "steep_full_deg", std::max(50.0, static_cast<double>(ramp.steep_from_deg)), between(0, 90)));
    if (ramp.steep_full_deg < ramp.steep_from_deg)
        node.fail("\"steep_full_deg\" must be at least \"steep_from_deg\"");
    object.no_other_keys();
    return ramp;
}

Material read_material(const std::string& name, const JsonNode& node) {
    JsonObject object(node);
    Material material;
    material.name = name;
    material.colour = object.colour_or("colour", material.colour);
    material.diffuse = static_cast<float>(object.number_or("diffuse", 1, between(0, 100)));
    material.specular = static_cast<float>(object.number_or("specular", 0, between(0, 100)));
    material.exponent = static_cast<float>(object.number_or("exponent", 10, between(0, 100000)));
    if (const auto ramp = object.optional("ramp")) material.ramp = read_ramp(*ramp);
    object.no_other_keys();
    return material;
}

}  // namespace

Light read_light(const JsonNode& node) {
    JsonObject object(node);
    Light light;
    if (const auto node_of_sun = object.optional("sun")) {
        JsonObject sun(*node_of_sun);
        light.to_sun = to_sun(sun);
        light.sun = sun.colour_or("colour", light.sun);
        light.shadows = sun.boolean_or("shadows", false) ? Shadows::Soft : Shadows::Off;
        sun.no_other_keys();
    }
    light.sky_ambient = object.colour_or("sky_ambient", light.sky_ambient);
    light.ground_ambient = object.colour_or("ground_ambient", light.ground_ambient);
    object.no_other_keys();
    return light;
}

Background read_background(const JsonNode& node) {
    JsonObject object(node);
    Background background;
    background.zenith = object.colour_or("zenith", background.zenith);
    background.horizon = object.colour_or("horizon", background.horizon);
    if (const auto model = object.optional("model")) {
        const std::string name = model->text();
        if (name == "cie_clear")
            background.model = SkyModel::CieClear;
        else if (name != "gradient")
            model->fail("must be \"gradient\" or \"cie_clear\"");
    }
    background.sun_disc = object.boolean_or("sun_disc", false);
    object.no_other_keys();
    return background;
}

Haze read_haze(const JsonNode& node) {
    JsonObject object(node);
    Haze haze;
    haze.range_m = object.required("range_m").number(at_least(0));
    haze.colour = object.colour_or("colour", haze.colour);
    object.no_other_keys();
    return haze;
}

std::vector<Material> read_materials(const JsonNode& node) {
    JsonObject object(node);
    std::vector<Material> materials;
    if (node.value().size() > 65535) node.fail("must have at most 65535 materials");
    for (const auto& entry : node.value().items()) {  // nlohmann's objects are sorted by key
        if (entry.key().empty()) node.fail("a material needs a name");
        materials.push_back(read_material(entry.key(), object.required(entry.key())));
    }
    return materials;
}

std::uint16_t MaterialNames::index_of(const JsonNode& node) const {
    const std::string name = node.text();
    const auto found = std::lower_bound(materials_.begin(), materials_.end(), name,
                                        [](const Material& m, const std::string& n) { return m.name < n; });
    if (found == materials_.end() || found->name != name)
        node.fail(fmt::format("no material is named \"{}\"", name));
    return static_cast<std::uint16_t>(found - materials_.begin());
}

}  // namespace keikan
