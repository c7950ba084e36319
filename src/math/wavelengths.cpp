// Wavelength sampling by inversion of a smooth density near the eye's response.
#include "math/wavelengths.h"

#include "math/colour.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sunfleck::engine {

namespace {

/// Shape of the density: two bells 1 / (1 + x^2)^2, one over the responses of green and red, one
/// over that of blue. Centres, widths and heights were fitted (docs/method/errors.md) to minimise
/// the standard deviation, over shifts of the lattice, of the colours of D65, of smooth
/// reflectances under it and of lamps, after one pass, two, four and a batch. The heavy tails cover
/// all visible wavelengths, and only + - * / are needed.
double shape(double nm) {
    const auto bell = [nm](double centre, double width) {
        const double x = (nm - centre) / width;
        return 1 / ((1 + x * x) * (1 + x * x));
    };
    return bell(591, 130) + 1.45 * bell(456, 88);
}

/// A density that is linear between whole nm, and its cumulative distribution from kFirstNm.
struct Distribution {
    std::array<double, kVisibleCount> density{};
    std::array<double, kVisibleCount> below{};

    Distribution() {
        for (std::size_t i = 0; i < kVisibleCount; ++i)
            density[i] = shape(kFirstNm + static_cast<double>(i));
        for (std::size_t i = 1; i < kVisibleCount; ++i)
            below[i] = below[i - 1] + 0.5 * (density[i - 1] + density[i]);
        const double total = below.back();
        for (std::size_t i = 0; i < kVisibleCount; ++i) {
            density[i] /= total;
            below[i] /= total;
        }
    }

    struct Drawn {
        double nm;
        double density;
    };

    /// Inverts the cumulative distribution. @param fraction  in [0,1).
    Drawn at(double fraction) const {
        const auto cell = static_cast<std::size_t>(std::distance(
            below.begin() + 1, std::upper_bound(below.begin() + 1, below.end() - 1, fraction)));
        const double start = density[cell];
        const double slope = density[cell + 1] - start;
        const double rest = std::max(fraction - below[cell], 0.0);
        // Solves start x + slope x^2 / 2 = rest in the form that does not divide by the slope.
        const double end = std::sqrt(std::max(start * start + 2 * slope * rest, 0.0));
        const double x = std::min(2 * rest / (start + end), 1.0);
        return {kFirstNm + static_cast<double>(cell) + x, start + slope * x};
    }
};

/// Returns the bit-reversed index of a pass in its batch, so that 2, 4, 8 passes form lattices too.
std::uint32_t place_in_batch(std::uint32_t pass) {
    static_assert(kBatchPasses == 16);
    const std::uint32_t n = pass % kBatchPasses;
    return (n & 1U) << 3U | (n & 2U) << 1U | (n & 4U) >> 1U | (n & 8U) >> 3U;
}

}  // namespace

Wavelengths Wavelengths::of_pass(PassId pass) {
    static const Distribution distribution;
    RandomStream stream(pass.seed, Purpose::wavelengths, pass.number / kBatchPasses, 0);
    // The shift covers the interval of a pass, not a lattice cell: so each pass alone is unbiased,
    // and a render that ends within a batch is too.
    const double shift = stream.next() + place_in_batch(pass.number) * (1.0 / kBatchPasses);
    const double place = shift < 1 ? shift : shift - 1;
    Wavelengths drawn;
    for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength) {
        const auto [nm, density] =
            distribution.at((static_cast<double>(wavelength) + place) / kWavelengths);
        drawn.nm[wavelength] = static_cast<float>(nm);
        drawn.density[wavelength] = static_cast<float>(density);
        const Triple response = rgb_response(nm);
        for (std::size_t i = 0; i < 3; ++i)
            drawn.rgb_weight[i][wavelength] =
                static_cast<float>(response[i] / (kWavelengths * density));
    }
    return drawn;
}

void Wavelengths::transform_rgb(const Rows& rows) {
    const std::array<SampledSpectrum, 3> before = rgb_weight;
    for (std::size_t i = 0; i < 3; ++i)
        rgb_weight[i] = before[0] * static_cast<float>(rows[i][0]) +
                        before[1] * static_cast<float>(rows[i][1]) +
                        before[2] * static_cast<float>(rows[i][2]);
}

}  // namespace sunfleck::engine
