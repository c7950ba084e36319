// The dial of the watch: numerals built of strokes, minutes, small seconds, hands.

#include "procedural/extrusion.h"
#include "procedural/placement.h"
#include "procedural/revolution.h"
#include "procedural/watch_parts.h"

#include <cmath>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr double kDial = 5.9;       // height of its face
constexpr double kNumerals = 14.7;  // radius of their middles
constexpr double kTall = 2.1;       // half the height of a numeral
constexpr double kSeconds = -8.2;   // y of the small seconds' middle
// 6 o'clock gives way to the small seconds.
constexpr std::array<std::string_view, 12> kRoman = {"XII", "I",   "II",   "III", "IIII", "V",
                                                     "",    "VII", "VIII", "IX",  "X",    "XI"};

struct Stroke {
    Vec3d from;
    Vec3d to;
    double width = 0.2;
    double height = 0.2;  // above the dial
};

/// A bar that is `width` wide along x (its ends are level), sunk into the dial.
Mesh bar(const Stroke& s) {
    const Vec3d half(s.width / 2, 0, 0);
    return extrude({s.from - half, s.from + half, s.to + half, s.to - half}, {},
                   kDial - 0.3 * s.height, kDial + s.height);
}

double glyph_width(char glyph) {
    return glyph == 'I' ? 0.8 : 1.9;
}

/// One letter with its serifs. Thin strokes lean one way, thick ones the other.
Mesh glyph(char letter, double x) {
    const double lean = letter == 'I' ? 0 : 0.6;
    const double foot = letter == 'V' ? 0.05 : -lean;  // V meets below, X crosses
    Mesh mesh =
        bar({{x + (letter == 'V' ? -0.05 : lean), -kTall, 0}, {x - lean, kTall, 0}, 0.46, 0.2});
    if (letter != 'I') mesh.append(bar({{x + foot, -kTall, 0}, {x + lean, kTall, 0}, 0.2, 0.22}));
    return mesh;
}

Mesh numeral(std::string_view text) {
    double width = 0;
    for (const char letter : text) width += glyph_width(letter);
    Mesh mesh;
    double x = -width / 2;
    for (const char letter : text) {
        mesh.append(glyph(letter, x + glyph_width(letter) / 2));
        x += glyph_width(letter);
    }
    for (const double end : {-kTall, kTall})
        mesh.append(bar({{0, end - 0.07, 0}, {0, end + 0.07, 0}, width, 0.24}));
    return mesh;
}

/// A flat ring on the dial.
Mesh ring(double radius, double half_width, const Vec3d& middle) {
    const double low = kDial - 0.1;
    const double high = kDial + 0.12;
    const Profile profile = {{radius - half_width, low},
                             {radius + half_width, low},
                             {radius + half_width, high},
                             {radius - half_width, high},
                             {radius - half_width, low}};
    return placed(revolve(profile, 192), at(middle));
}

void append_ticks(Mesh& mesh, int count, int bold_every, const std::array<double, 2>& radii,
                  const Vec3d& middle) {
    for (int i = 0; i < count; ++i) {
        const double width = i % bold_every == 0 ? 0.34 : 0.13;
        const Mesh tick = bar({{0, radii[0], 0}, {0, radii[1], 0}, width, 0.16});
        mesh.append(placed(tick, turned(-static_cast<double>(i) / count, middle)));
    }
}

/// Stem, ring and tip after Breguet's manner, along y from the origin.
Mesh hand(double length, double width, double height) {
    const double eye = length * 0.72;
    const double r = width * 2.1;
    const Polygon stem = {{-width / 2, -length * 0.2, 0},
                          {width / 2, -length * 0.2, 0},
                          {width * 0.3, eye - r * 0.9, 0},
                          {-width * 0.3, eye - r * 0.9, 0}};
    const Polygon tip = {
        {-width * 0.4, eye + r * 0.85, 0}, {width * 0.4, eye + r * 0.85, 0}, {0, length, 0}};
    const Mesh boss =
        extrude(ellipse(width * 1.3, width * 1.3, 48), {}, height - 0.02, height + 0.22);
    Mesh mesh = extrude(stem, {}, height, height + 0.2);
    mesh.append(extrude(tip, {}, height, height + 0.2));
    mesh.append(boss);
    mesh.append(placed(
        extrude(ellipse(r, r, 48), {ellipse(r * 0.72, r * 0.72, 48)}, height + 0.01, height + 0.21),
        at({0, eye, 0})));
    return mesh;
}

}  // namespace

Mesh watch_dial() {
    return revolve({{0, 5.3}, {19.9, 5.3}, {19.9, kDial}, {0, kDial}}, 384);
}

Mesh watch_marks() {
    Mesh marks;
    for (std::size_t hour = 0; hour < kRoman.size(); ++hour) {
        if (kRoman.at(hour).empty()) continue;
        const Placement place =
            turned(-static_cast<double>(hour) / 12, Vec3d(0)) * at({0, kNumerals, 0});
        marks.append(placed(numeral(kRoman.at(hour)), place));
    }
    for (const double radius : {17.6, 19.1}) marks.append(ring(radius, 0.06, Vec3d(0)));
    append_ticks(marks, 60, 5, {17.6, 19.1}, Vec3d(0));
    const Vec3d seconds(0, kSeconds, 0);
    for (const double radius : {3.7, 4.5}) marks.append(ring(radius, 0.05, seconds));
    append_ticks(marks, 60, 15, {3.72, 4.48}, seconds);
    return marks;
}

Mesh watch_hands() {
    constexpr double kMinutes = 9.0 / 60;
    Mesh hands = placed(hand(10.5, 0.85, 6.6), turned(-(10 + kMinutes) / 12, Vec3d(0)));
    hands.append(placed(hand(16, 0.65, 7.1), turned(-kMinutes, Vec3d(0))));
    hands.append(revolve({{0, 5.5}, {0.35, 5.5}, {0.35, 7.4}, {0.2, 7.6}, {0, 7.6}}, 48));
    const Placement second = turned(-0.62, {0, kSeconds, 0});
    hands.append(
        placed(extrude({{-0.14, -1.4, 0}, {0.14, -1.4, 0}, {0.04, 3.6, 0}, {-0.04, 3.6, 0}}, {},
                       6.25, 6.35),
               second));
    hands.append(placed(revolve({{0, 5.5}, {0.25, 5.5}, {0.25, 6.45}, {0, 6.5}}, 24), second));
    return hands;
}

}  // namespace sunfleck::engine
