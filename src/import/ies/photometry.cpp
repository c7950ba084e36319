// The layout of the file, and the symmetries of its angles.
#include "import/ies/photometry.h"

#include "import/ies/numbers.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr double kMostCandela = 1e12;

/// Returns the first byte after the line of TILT, and whether factors of lamps follow there.
struct Tilt {
    std::size_t end = 0;
    bool has_factors = false;
};

Tilt tilt_of(const std::string& text, const std::string& name) {
    std::size_t begin = text.starts_with("TILT=") ? 0 : text.find("\nTILT=");
    if (begin == std::string::npos) begin = text.find("\rTILT=");
    if (begin == std::string::npos)
        throw Error({name}, "has no line TILT=, so it is no IES file",
                    "name a file of luminaire data (ANSI/IES LM-63)");
    const std::size_t word = text.find('=', begin) + 1;
    const std::size_t end = std::min(text.find_first_of("\r\n", word), text.size());
    return {end, text.substr(word, end - word).starts_with("INCLUDE")};
}

/// The number after the ballast factor has had no use since 2002, and is of how the file was made
/// since 2019.
bool has_second_factor(const std::string& text) {
    const std::string_view first_line(text.data(), std::min(text.find('\n'), text.size()));
    return first_line.find("63-2002") == std::string_view::npos &&
           first_line.find("63-2019") == std::string_view::npos;
}

void skip_tilt_factors(IesNumbers& numbers) {
    numbers.next("the lamp's position");
    const std::size_t pairs = numbers.count("the number of tilt angles");
    for (std::size_t i = 0; i < 2 * pairs; ++i) numbers.next("a tilt angle or its factor");
}

std::vector<double> increasing(IesNumbers& numbers, std::size_t count, const char* what) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < count; ++i) {
        angles.push_back(numbers.next(what));
        if (!(angles.back() >= 0 && angles.back() <= 360))
            numbers.refuse(std::string(what) + " that is not from 0 to 360", "correct it");
        if (i > 0 && !(angles[i] > angles[i - 1]))
            numbers.refuse(std::string(what) + " that is not greater than the one before",
                           "sort angles and intensities");
    }
    return angles;
}

/// Checks that horizontal angles are those of one of the symmetries.
void check_symmetry(const std::vector<double>& horizontals, const IesNumbers& numbers) {
    const double first = horizontals.front();
    const double last = horizontals.back();
    const bool is_known = horizontals.size() == 1 ||
                          (first == 0 && (last == 90 || last == 180 || last > 180)) ||
                          (first == 90 && last == 270);
    if (!is_known)
        numbers.refuse("horizontal angles of no symmetry of type C",
                       "let them go from 0 to 90, 180 or 360, or from 90 to 270");
}

/// Returns the index of the last angle that is at most `angle`, but not the very last.
std::size_t before(const std::vector<double>& angles, double angle) {
    const auto above = std::upper_bound(angles.begin() + 1, angles.end() - 1, angle);
    return static_cast<std::size_t>(above - angles.begin()) - 1;
}

struct Between {
    std::size_t low;
    double rest;  // share of the next
};

Between place_of(const std::vector<double>& angles, double angle) {
    if (angles.size() == 1) return {0, 0};
    const std::size_t low = before(angles, angle);
    return {low, std::clamp((angle - angles[low]) / (angles[low + 1] - angles[low]), 0.0, 1.0)};
}

double degrees(double radians) {
    return radians * 180 / kPiDouble;
}

}  // namespace

Photometry::Photometry(const std::string& text, const std::string& name) {
    const Tilt tilt = tilt_of(text, name);
    IesNumbers numbers(text, tilt.end, name);
    if (tilt.has_factors) skip_tilt_factors(numbers);
    numbers.next("the number of lamps");
    numbers.next("the lumens of a lamp");
    double factor = numbers.next("the multiplier of candela");
    const std::size_t verticals = numbers.count("the number of vertical angles");
    const std::size_t horizontals = numbers.count("the number of horizontal angles");
    const double type = numbers.next("the photometric type");
    if (type != 1)
        numbers.refuse(type == 2 || type == 3 ? std::string("is photometry of type ") +
                                                    (type == 2 ? 'B' : 'A') + ", which is not read"
                                              : "a photometric type that is none",
                       "convert it to type C");
    for (const char* what : {"the type of units", "the width", "the length", "the height"})
        numbers.next(what);
    factor *= numbers.next("the ballast factor");
    const double second = numbers.next("the ballast-lamp factor");
    if (has_second_factor(text) && second > 0) factor *= second;
    numbers.next("the input watts");
    verticals_ = increasing(numbers, verticals, "a vertical angle");
    horizontals_ = increasing(numbers, horizontals, "a horizontal angle");
    check_symmetry(horizontals_, numbers);
    for (std::size_t i = 0; i < verticals * horizontals; ++i) {
        candela_.push_back(factor * numbers.next("an intensity"));
        if (!(candela_.back() >= 0 && candela_.back() <= kMostCandela))
            numbers.refuse("an intensity that cannot be", "correct it, or the factors");
    }
}

double Photometry::measured_angle(double horizontal) const {
    const double last = horizontals_.back();
    if (horizontals_.size() == 1) return horizontals_.front();
    if (horizontals_.front() == 90)  // a plane of symmetry from 90 to 270
        return horizontal < 90    ? 180 - horizontal
               : horizontal > 270 ? 540 - horizontal
                                  : horizontal;
    if (last > 180) return horizontal;
    const double half = horizontal > 180 ? 360 - horizontal : horizontal;
    return last == 90 && half > 90 ? 180 - half : half;
}

double Photometry::candela(double vertical, double horizontal) const {
    if (vertical < verticals_.front() || vertical > verticals_.back()) return 0;
    const double angle = measured_angle(horizontal);
    const Between v = place_of(verticals_, vertical);
    const std::size_t rows = verticals_.size();
    const auto along_row = [&](std::size_t row) {
        const double* values = &candela_[row * rows];
        const double next = v.rest > 0 ? values[v.low + 1] : values[v.low];
        return values[v.low] + v.rest * (next - values[v.low]);
    };
    const bool beyond = horizontals_.back() > 180 && angle > horizontals_.back();
    if (beyond) {  // the circle closes between the last angle and the first
        const double rest = (angle - horizontals_.back()) / (360 - horizontals_.back());
        const double last = along_row(horizontals_.size() - 1);
        return last + rest * (along_row(0) - last);
    }
    const Between h = place_of(horizontals_, angle);
    const double low = along_row(h.low);
    return h.rest > 0 ? low + h.rest * (along_row(h.low + 1) - low) : low;
}

double Photometry::candela(const Vec3d& w) const {
    // In float the arcus functions have the same bits on all machines.
    const auto flat = static_cast<float>(std::sqrt(w.x * w.x + w.y * w.y));
    const double vertical = std::atan2(flat, static_cast<float>(-w.z));
    const double around = std::atan2(static_cast<float>(w.y), static_cast<float>(w.x));
    return candela(std::clamp(degrees(vertical), 0.0, 180.0),
                   degrees(around < 0 ? around + 2 * kPiDouble : around));
}

}  // namespace sunfleck::engine
