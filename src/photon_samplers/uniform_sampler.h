// UniformSampler and RandomSampler, without Markov chains. The emission dimensions of `uniform` are
// a digital net; those of `random` are independent.
#pragma once

#include "photon/independent_paths.h"
#include "photon_samplers/model.h"

#include <string>

namespace sunfleck::engine {

enum class UniformKind { random, uniform };

/// Returns the default number of photon paths of a pass: two for each pixel, at least 200,000.
std::uint32_t usual_photon_paths(std::size_t pixels);

/// Adds the light of a stratum's uniform paths to the target, and its counts to `totals`.
/// @param stratum  with no levels in its plan. @return the visible fraction.
double trace_uniform_stratum(const PhotonPass& pass, UniformKind kind, const LightStratum& stratum,
                             const PhotonTarget& target, PhotonTotals& totals);

/// Adds the light of a stratum's guided paths, which are of full support. @return their counts.
TracedPaths trace_guided_paths(const PhotonPass& pass, const LightStratum& stratum,
                               const PhotonTarget& target, PhotonTotals& totals);

/// Counts uniform paths, of which each visible one contributed once. @return the visible fraction.
double count_uniform(Statistics& counts, Statistics& all);

/// Traces a pass of uniform paths alone.
PhotonTotals trace_uniform_strata(const PhotonPass& pass, UniformKind kind,
                                  const PhotonTarget& target);

struct UniformSampler {
    using State = NoState;
    static constexpr PhotonSampler kind = PhotonSampler::uniform;
    static constexpr std::string_view name = "uniform";
    static constexpr std::string_view what =
        "low-discrepancy points, evenly spread over the lights";
    static constexpr bool learns = false;
    static constexpr SamplerMemory memory{650, 180};

    static std::uint32_t default_paths(std::size_t pixels) { return usual_photon_paths(pixels); }
    static std::string settings_text(const PhotonSettings&) { return {}; }
    static PhotonTotals trace(const PhotonPass& pass, const PhotonTarget& target, State&) {
        return trace_uniform_strata(pass, UniformKind::uniform, target);
    }
};

struct RandomSampler {
    using State = NoState;
    static constexpr PhotonSampler kind = PhotonSampler::random;
    static constexpr std::string_view name = "random";
    static constexpr std::string_view what = "independent random numbers: the paper's baseline";
    static constexpr bool learns = false;
    static constexpr SamplerMemory memory = UniformSampler::memory;

    static std::uint32_t default_paths(std::size_t pixels) { return usual_photon_paths(pixels); }
    static std::string settings_text(const PhotonSettings&) { return {}; }
    static PhotonTotals trace(const PhotonPass& pass, const PhotonTarget& target, State&) {
        return trace_uniform_strata(pass, UniformKind::random, target);
    }
};

}  // namespace sunfleck::engine
