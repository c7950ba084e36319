// Where the sun stands, by place and time.
//
// Source: Meeus, Astronomical Algorithms (1998), chapters 7, 12, 13 and 25, low accuracy: within
// 0.01 degrees between 1950 and 2050. Refraction, by which the sun seems up to half a degree higher
// at the horizon, is left out.
#pragma once

namespace sunfleck::engine {

struct SunPosition {
    double azimuth = 0;    // degrees clockwise from north, 0 to 360
    double elevation = 0;  // degrees over the horizon
};

/// A moment of the Gregorian calendar.
struct CivilTime {
    int year = 2000;
    int month = 1;
    int day = 1;
    double hours = 12;      // of the clock
    double utc_offset = 0;  // hours that the clock is ahead of UTC
};

struct Place {
    double latitude = 0;   // degrees north
    double longitude = 0;  // degrees east
};

SunPosition solar_position(const CivilTime& time, const Place& place);

}  // namespace sunfleck::engine
