// Small renders for tests: a scene from text, the mean of some passes, statistics of numbers.
#pragma once

#include "import/pbrt/reader.h"
#include "render/pass.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace sunfleck::engine::testing_support {

/// Film of n x n pixels with a box filter of one pixel: no light crosses between pixels.
inline std::string film(int n) {
    const std::string size = std::to_string(n);
    return R"(Film "rgb" "integer xresolution" )" + size + R"( "integer yresolution" )" + size +
           R"(
PixelFilter "box" "float xradius" 0.5 "float yradius" 0.5
)";
}

/// Camera and film: all that comes before the world. @param look  nine numbers of LookAt.
inline std::string view(const std::string& look, double fov, int n) {
    return "LookAt " + look + R"(
Camera "perspective" "float fov" )" +
           std::to_string(fov) + "\n" + film(n) + "WorldBegin\n";
}

inline std::string diffuse(const std::string& rgb) {
    return R"(Material "diffuse" "rgb reflectance" [)" + rgb + "]\n";
}

/// @param points  four corners, counter-clockwise as seen from the normal's side.
inline std::string quad(const std::string& points) {
    return R"(Shape "trianglemesh" "point3 P" [)" + points + R"(] "integer indices" [0 1 2 0 2 3]
)";
}

/// A box with its normals outside.
inline std::string box(const Vec3d& low, const Vec3d& high) {
    std::ostringstream text;
    text << R"(Shape "trianglemesh" "point3 P" [)";
    for (const double z : {low.z, high.z})
        text << low.x << ' ' << low.y << ' ' << z << "  " << high.x << ' ' << low.y << ' ' << z
             << "  " << high.x << ' ' << high.y << ' ' << z << "  " << low.x << ' ' << high.y << ' '
             << z << "  ";
    text << R"(] "integer indices" [0 2 1 0 3 2  4 5 6 4 6 7  0 1 5 0 5 4
1 2 6 1 6 5  2 3 7 2 7 6  3 0 4 3 4 7]
)";
    return text.str();
}

inline Scene scene_of(const std::string& text) {
    return Scene(read_pbrt_text(text, "test.pbrt"));
}

inline double luminance(const Vec3d& rgb) {
    return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

inline Vec3d pixel_value(const PassImage& image, std::size_t i, Aov aov = Aov::total) {
    return {image.value(aov, i, 0).to_double(), image.value(aov, i, 1).to_double(),
            image.value(aov, i, 2).to_double()};
}

struct MeanPicture {
    int width = 0;
    int height = 0;
    std::vector<Vec3d> rgb;
    Statistics statistics;

    Vec3d at(int x, int y) const { return rgb[static_cast<std::size_t>(y * width + x)]; }
    Vec3d mean() const { return mean(0, 0, width, height); }
    /// Mean over pixels [x0, x1) x [y0, y1).
    Vec3d mean(int x0, int y0, int x1, int y1) const {
        Vec3d sum(0);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) sum += at(x, y);
        return sum / ((x1 - x0) * (y1 - y0));
    }
};

/// Mean of passes [0, end), of one aov.
inline MeanPicture render_mean(const Scene& scene, const RenderSettings& settings,
                               std::uint32_t end, Aov aov = Aov::total) {
    const PixelWindow window = window_of(scene.film());
    MeanPicture result{
        window.width(), window.height(), std::vector<Vec3d>(window.pixels(), Vec3d(0)), {}};
    std::optional<Epoch> epoch;
    for (std::uint32_t p = 0; p < end; ++p) {
        if (!epoch || epoch->number != epoch_of(p)) epoch = learn_epoch(scene, settings, p);
        const PassResult pass = render_pass(scene, settings, p, *epoch);
        for (std::size_t i = 0; i < result.rgb.size(); ++i)
            result.rgb[i] += pixel_value(pass.image, i, aov) / end;
        result.statistics += pass.statistics;
    }
    return result;
}

/// Mean and standard error of independent numbers.
struct Estimate {
    double mean = 0;
    double error = 0;

    static Estimate of(const std::vector<double>& values) {
        const auto count = static_cast<double>(values.size());
        double mean = 0;
        for (const double v : values) mean += v / count;
        double squares = 0;
        for (const double v : values) squares += (v - mean) * (v - mean);
        return {mean, std::sqrt(squares / (count * (count - 1)))};
    }

    /// @param value  called with 0 .. renders - 1: a number that depends on this seed alone.
    template <class F>
    static Estimate over(int renders, const F& value) {
        std::vector<double> values(static_cast<std::size_t>(renders));
        for (int i = 0; i < renders; ++i) values[static_cast<std::size_t>(i)] = value(i);
        return of(values);
    }
};

/// What an equivalence test asks: how far from one the ratio a / b may be, with 99% confidence.
/// Small only if the estimates agree and are precise.
inline double worst_ratio(const Estimate& a, const Estimate& b) {
    const double relative_a = a.error / a.mean;
    const double relative_b = b.error / b.mean;
    return std::abs(a.mean / b.mean - 1) +
           2.58 * std::sqrt(relative_a * relative_a + relative_b * relative_b);
}

}  // namespace sunfleck::engine::testing_support
