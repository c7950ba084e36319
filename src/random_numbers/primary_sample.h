// Primary sample of a photon path: the meaning of each dimension of u in [0,1)^D.
//
// The layout is fixed: emission dimensions first, then four dimensions per scattering event, so
// that a small change of u is a small change of the path. A dimension is a 64-bit fraction of the
// unit interval with exact wrap-around. It is read once or never; dimensions that are never read
// are never drawn.
#pragma once

#include "core/random.h"

#include <concepts>

namespace sunfleck::engine {

enum class EmissionDimension : std::uint32_t {
    position_u,
    position_v,
    direction_u,
    direction_v,
    light,
    hero,  // the wavelength that a dispersive refraction keeps
    count
};
enum class BounceDimension : std::uint32_t { lobe, direction_u, direction_v, roulette, count };

constexpr std::uint32_t dimension(EmissionDimension which) {
    return static_cast<std::uint32_t>(which);
}

/// @param bounce  0 at the first surface that scatters the photon; a flight through a medium that
/// may scatter it counts as a bounce, too.
constexpr std::uint32_t dimension(std::uint32_t bounce, BounceDimension which) {
    return dimension(EmissionDimension::count) +
           bounce * static_cast<std::uint32_t>(BounceDimension::count) +
           static_cast<std::uint32_t>(which);
}

/// Returns whether the dimension belongs to the emission.
constexpr bool is_emission(std::uint32_t index) {
    return index < dimension(EmissionDimension::count);
}

/// Returns dimension i of a path's own stream. Bounce dimensions use at most 23 bits, so each takes
/// one word, and all dimensions of a bounce share one random block. Emission dimensions have 64
/// bits.
constexpr std::uint64_t dimension_of(RandomStream& stream, std::uint32_t index) {
    if (is_emission(index)) return stream.at(index);
    constexpr std::uint32_t kEmissionDimensions = dimension(EmissionDimension::count);
    static_assert(2 * kEmissionDimensions % 4 == 0);
    return std::uint64_t{stream.word(index + kEmissionDimensions)} << 32U;
}

/// Access of a path tracer to its primary sample: by dimension index, with the same value each
/// time. Photon samplers differ in their readers alone.
template <class R>
concept PrimarySampleReader = requires(R& read, std::uint32_t index) {
    { read(index) } -> std::same_as<std::uint64_t>;
};

/// Reader of independent uniform dimensions from the path's own stream.
class IndependentReader {
public:
    explicit IndependentReader(RandomStream stream) : stream_(stream) {}
    std::uint64_t operator()(std::uint32_t index) { return dimension_of(stream_, index); }

private:
    RandomStream stream_;
};

static_assert(PrimarySampleReader<IndependentReader>);

/// Independent primary samples for the paths of a pass: the uniform sampling of the paper.
class IndependentPoints {
public:
    explicit IndependentPoints(PassId pass) : pass_(pass) {}
    IndependentReader path(std::uint32_t number) const {
        return IndependentReader(pass_.stream(Purpose::uniform_path, number));
    }

private:
    PassId pass_;
};

}  // namespace sunfleck::engine
