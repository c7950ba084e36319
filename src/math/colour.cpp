// The tables behind math/colour.h, built once from the committed numbers.
#include "math/colour.h"

#include "math/colour_matrix.h"
#include "math/data_illuminants.h"
#include "math/data_observer.h"

#include <algorithm>

namespace sunfleck::engine {

namespace {

/// D65 between its points, 5 nm apart from 300 nm on; at whole nm.
double d65_at(std::size_t nm) {
    const std::size_t cell = std::min((nm - 300) / 5, spectra_data::kIlluminantD65.size() - 2);
    const double part = static_cast<double>(nm - 300 - 5 * cell) / 5;
    return spectra_data::kIlluminantD65[cell] * (1 - part) +
           spectra_data::kIlluminantD65[cell + 1] * part;
}

struct Colour {
    std::array<double, kVisibleCount> luminance{};
    std::array<double, kVisibleCount> white{};
    std::array<Triple, kVisibleCount> rgb{};
    Rows xyz_of_rgb{};
    Rows rgb_of_xyz{};

    Colour() {
        Triple white_xyz{};
        for (std::size_t i = 0; i < kVisibleCount; ++i) {
            luminance[i] = spectra_data::kObserverY[i] / kYIntegral;
            white[i] = d65_at(kFirstNm + i);
            white_xyz[0] += white[i] * spectra_data::kObserverX[i] / kYIntegral;
            white_xyz[1] += white[i] * luminance[i];
            white_xyz[2] += white[i] * spectra_data::kObserverZ[i] / kYIntegral;
        }
        const double scale = 1 / white_xyz[1];
        for (double& value : white) value *= scale;
        for (double& value : white_xyz) value *= scale;
        build_matrices(white_xyz);
        for (std::size_t i = 0; i < kVisibleCount; ++i) {
            rgb[i] = rgb_of_xyz * Triple{spectra_data::kObserverX[i] / kYIntegral, luminance[i],
                                         spectra_data::kObserverZ[i] / kYIntegral};
        }
    }

private:
    void build_matrices(const Triple& white_xyz) {
        const Rows primaries{Triple{0.64, 0.30, 0.15}, Triple{0.33, 0.60, 0.06},
                             Triple{0.03, 0.10, 0.79}};
        xyz_of_rgb = xyz_of_primaries(primaries, white_xyz);
        rgb_of_xyz = inverse(xyz_of_rgb);
    }
};

const Colour& colour() {
    static const Colour built;
    return built;
}

}  // namespace

const std::array<Triple, kVisibleCount>& rgb_response() {
    return colour().rgb;
}

Triple rgb_response(double nm) {
    const double position = std::clamp(nm - kFirstNm, 0.0, double{kLastNm - kFirstNm});
    const std::size_t cell = std::min(static_cast<std::size_t>(position), kVisibleCount - 2);
    const double part = position - static_cast<double>(cell);
    const Triple& below = colour().rgb[cell];
    const Triple& above = colour().rgb[cell + 1];
    Triple between{};
    for (std::size_t i = 0; i < 3; ++i) between[i] = below[i] * (1 - part) + above[i] * part;
    return between;
}

const std::array<double, kVisibleCount>& white() {
    return colour().white;
}

const std::array<double, kVisibleCount>& luminance_response() {
    return colour().luminance;
}

Triple xyz_of_rgb(const Triple& rgb) {
    return colour().xyz_of_rgb * rgb;
}

Triple rgb_of_xyz(const Triple& xyz) {
    return colour().rgb_of_xyz * xyz;
}

}  // namespace sunfleck::engine
