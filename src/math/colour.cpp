// The tables behind math/colour.h, built once from the committed numbers.
#include "math/colour.h"

#include "math/data_illuminants.h"
#include "math/data_observer.h"

#include <algorithm>

namespace sunfleck {

namespace {

using Rows = std::array<Triple, 3>;

Triple operator*(const Rows& m, const Triple& v) {
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

Rows inverse(const Rows& m) {
    Rows cofactor{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t a = (i + 1) % 3;
            const std::size_t b = (i + 2) % 3;
            const std::size_t c = (j + 1) % 3;
            const std::size_t d = (j + 2) % 3;
            cofactor[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    }
    const double determinant =
        m[0][0] * cofactor[0][0] + m[0][1] * cofactor[1][0] + m[0][2] * cofactor[2][0];
    for (Triple& row : cofactor)
        for (double& value : row) value /= determinant;
    return cofactor;
}

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
    /// Columns are the primaries' x, y, 1-x-y, each scaled so that together they make the white.
    void build_matrices(const Triple& white_xyz) {
        const Rows primaries{Triple{0.64, 0.30, 0.15}, Triple{0.33, 0.60, 0.06},
                             Triple{0.03, 0.10, 0.79}};
        const Triple amount = inverse(primaries) * white_xyz;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) xyz_of_rgb[i][j] = primaries[i][j] * amount[j];
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

}  // namespace sunfleck
