// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/sun_position.hpp"
#include "degree.hpp"

#include <chrono>
#include <cmath>
#include <numbers>

namespace keikan {
namespace {

constexpr double kTerrestrialTimeAheadOfUtcDays = 70.0 / 86400;

/// Days since 2000-01-01 12:00 UTC (Julian day 2451545.0).
double days_since_j2000(const ClockTime& t) {
    using namespace std::chrono;
    const auto date =
        year{t.year} / month{static_cast<unsigned>(t.month)} / day{static_cast<unsigned>(t.day)};
    const auto days = (sys_days{date} - sys_days{year{2000} / January / 1}).count();
    const double hours = t.hour + t.minute / 60.0 + t.second / 3600.0 - t.utc_offset_hours - 12;
    return static_cast<double>(days) + hours / 24;
}

double within_turn(double degrees) {
    const double rest = std::fmod(degrees, 360.0);
    return rest < 0 ? rest + 360 : rest;
}

}  // namespace

SunPosition sun_position(const ClockTime& time, double latitude_deg, double longitude_deg) {
    const double days = days_since_j2000(time);
    const double t = (days + kTerrestrialTimeAheadOfUtcDays) / 36525;  // Julian centuries

    // Apparent longitude and obliquity (Meeus 25.2 to 25.8).
    const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = (357.52911 + t * (35999.05029 - t * 0.0001537)) * kDegree;
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
                          (0.019993 - t * 0.000101) * std::sin(2 * anomaly) +
                          0.000289 * std::sin(3 * anomaly);
    const double node = (125.04 - 1934.136 * t) * kDegree;
    const double longitude = (mean_longitude + centre - 0.00569 - 0.00478 * std::sin(node)) * kDegree;
    const double obliquity =
        (23.4392911 - t * (0.0130042 + t * (1.64e-7 - t * 5.036e-7)) + 0.00256 * std::cos(node)) * kDegree;

    // Equatorial frame.
    const double right_ascension = std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude));
    const double declination = std::asin(std::sin(obliquity) * std::sin(longitude));

    // Horizontal frame (12.4 and 13.5, 13.6), azimuth from north here.
    const double greenwich = within_turn(280.46061837 + 360.98564736629 * days + 0.000387933 * t * t);
    const double hour_angle = (greenwich + longitude_deg) * kDegree - right_ascension;
    const double latitude = latitude_deg * kDegree;
    const double elevation = std::asin(std::sin(latitude) * std::sin(declination) +
                                       std::cos(latitude) * std::cos(declination) * std::cos(hour_angle));
    const double east = -std::cos(declination) * std::sin(hour_angle);
    const double north = std::sin(declination) * std::cos(latitude) -
                         std::cos(declination) * std::sin(latitude) * std::cos(hour_angle);
    const double azimuth = std::atan2(east, north);
    return {azimuth < 0 ? azimuth + 2 * std::numbers::pi : azimuth, elevation};
}

glm::dvec3 direction_of(const SunPosition& sun) {
    const double level = std::cos(sun.elevation_rad);
    return {level * std::sin(sun.azimuth_rad), level * std::cos(sun.azimuth_rad),
            std::sin(sun.elevation_rad)};
}

}  // namespace keikan
