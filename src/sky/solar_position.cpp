// The sun's apparent longitude, then its direction by sidereal time.
#include "sky/solar_position.h"

#include "math/trigonometry.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

SinCos of_degrees(double angle) {
    return sin_cos_2pi(angle / 360);
}

/// Returns days since 2000-01-01 12:00 UTC.
double days_since_2000(const CivilTime& time) {
    const bool is_early = time.month <= 2;  // counted as the months 13 and 14 of the year before
    const int year = time.year - (is_early ? 1 : 0);
    const int month = time.month + (is_early ? 12 : 0);
    const double century = std::floor(year / 100.0);
    const double days = std::floor(365.25 * (year + 4716)) + std::floor(30.6001 * (month + 1)) +
                        time.day + 2 - century + std::floor(century / 4) - 1524.5;
    return days - 2451545 + (time.hours - time.utc_offset) / 24;
}

/// Returns the angle whose sine and cosine are in proportion to `y` and `x`, in degrees: in float,
/// where atan2 has the same bits on all machines.
double degrees_of(double y, double x) {
    const float angle = std::atan2(static_cast<float>(y), static_cast<float>(x));
    return static_cast<double>(angle) * 180 / kPiDouble;
}

}  // namespace

SunPosition solar_position(const CivilTime& time, const Place& place) {
    constexpr double kTerrestrial = 69.0 / 86400;  // of clocks ahead of the Earth's turning, days
    const double days = days_since_2000(time);
    const double t = (days + kTerrestrial) / 36525;
    const double anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * of_degrees(anomaly).sin +
                          (0.019993 - t * 0.000101) * of_degrees(2 * anomaly).sin +
                          0.000289 * of_degrees(3 * anomaly).sin;
    const SinCos node = of_degrees(125.04 - 1934.136 * t);
    const SinCos longitude = of_degrees(280.46646 + t * (36000.76983 + t * 0.0003032) + centre -
                                        0.00569 - 0.00478 * node.sin);
    const SinCos tilt = of_degrees(23.4392911 - t * 0.0130042 + 0.00256 * node.cos);

    const double turned = 280.46061837 + 360.98564736629 * days + 0.000387933 * t * t;
    const SinCos sidereal = of_degrees(turned - 0.00478 * node.sin * tilt.cos + place.longitude);
    const double x = longitude.cos;
    const double y = tilt.cos * longitude.sin;
    const double polar = tilt.sin * longitude.sin;
    const double meridian = x * sidereal.cos + y * sidereal.sin;
    const double west = x * sidereal.sin - y * sidereal.cos;

    const SinCos latitude = of_degrees(place.latitude);
    const double up = latitude.sin * polar + latitude.cos * meridian;
    const double north = latitude.cos * polar - latitude.sin * meridian;
    const double azimuth = degrees_of(-west, north);
    return {azimuth < 0 ? azimuth + 360 : azimuth,
            degrees_of(up, std::sqrt(north * north + west * west))};
}

}  // namespace sunfleck::engine
