// FreePath: how far light flies through a medium before it is scattered.
//
// In:  a straight way through a medium, the light that is carried there. Out: the chance to be
// scattered, distances by inversion of it, and what is left of the light.
//
// Absorption is a weight by Beer's law; only scattering is sampled. The wavelength that decides is
// chosen in proportion to what each still carries: with c_i the light and s_i the scattering of
// wavelength i, the chance to be scattered before the distance t is
//   F(t) = sum c_i (1 - exp(-s_i t)) / sum c_i,
// and light that is scattered at t, or passes, is divided by the density of that. But for
// absorption the sum of all wavelengths then stays what it was: media of any colour leave no
// flashes. Source: Kutz et al., Spectral and decomposition tracking (2017), for weights by what is
// carried. Equations: docs/method/media.md.
#pragma once

#include "geometry/ray.h"
#include "medium/medium.h"

namespace sunfleck::engine {

/// Returns what is left of light behind a way through a medium. Its length may be infinite: then
/// every wavelength that the medium acts on becomes zero.
SampledSpectrum transmittance(const SampledMedium& medium, const Ray& way);

/// By distances in a medium that is alike everywhere, by amounts in others (medium.h).
class FreePath {
public:
    /// @param carried  not negative. If it is zero, all wavelengths count alike: what chains learn
    /// does not depend on the colour of a light.
    FreePath(const SampledMedium& medium, const SampledSpectrum& carried);

    /// Returns F(t). @param distance  may be infinite.
    float chance(float distance) const { return chance_between(0, distance); }
    /// Returns F(to) - F(from), exact to float where the two are close. @param to  may be infinite.
    float chance_between(float from, float to) const;
    /// Returns dF/dt.
    float density(float distance) const;
    /// Inverts chance(). @param chance  in [0, chance(infinity)).
    float distance_at(float chance) const;

    /// Returns the factor of light that passes the distance, one over the chance included.
    SampledSpectrum passed(float distance) const;
    /// Returns the factor of light that is scattered at a distance, one over the density of it
    /// included.
    SampledSpectrum scattered(float distance) const;

private:
    /// Sums over wavelengths, over exp(-least_ t).
    struct Sums {
        float fallen = 0;   // 1 - F, less one: exact where it is small
        float density = 0;  // dF/dt
    };
    Sums sums_at(float distance) const;
    SampledSpectrum left_at(float distance) const;

    const SampledMedium& medium_;
    SampledSpectrum shares_;
    float least_ = 0;  // scattering of the wavelengths that carry anything
    float most_ = 0;
};

/// The end of a free path.
struct Flight {
    bool is_scattered = false;  // before the end of the way
    float distance = 0;         // to there, or the way's length
    SampledSpectrum weight;     // factor of the light
};

/// Follows light on a way through a medium that scatters. @param u  in [0,1).
Flight fly(const SampledMedium& medium, const Ray& way, const SampledSpectrum& carried, float u);

}  // namespace sunfleck::engine
