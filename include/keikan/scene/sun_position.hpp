// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

namespace keikan {

/// A moment by the clock on the wall, `utc_offset_hours` ahead of UTC (Japan: 9). Gregorian calendar.
struct ClockTime {
    int year = 2000;
    int month = 1;  ///< 1 ... 12
    int day = 1;
    int hour = 12;
    int minute = 0;
    double second = 0;
    double utc_offset_hours = 0;
};

struct SunPosition {
    double azimuth_rad = 0;    ///< from north, clockwise (east is pi/2), in [0, 2 pi)
    double elevation_rad = 0;  ///< of the sun's centre above the horizon, without refraction
};

/// Where the sun stands over a place: latitude north and longitude east of Greenwich are positive.
///
/// Method: the low-precision series for the sun's apparent longitude (J. Meeus, Astronomical Algorithms, 2nd
///         ed., chapter 25), sidereal time of Greenwich (chapter 12), then the horizontal frame (chapter 13).
///         Parallax (at most 0.0025 degrees) and UT1 - UTC (under a second) are left out, and the difference
///         between terrestrial time and UTC is taken as 70 s.
/// Error:  0.01 degrees in longitude, years 1950 to 2050; 0.02 degrees in the result.
SunPosition sun_position(const ClockTime& time, double latitude_deg, double longitude_deg);

/// Unit vector towards azimuth and elevation: x east, y north, z up.
glm::dvec3 direction_of(const SunPosition& sun);

}  // namespace keikan
