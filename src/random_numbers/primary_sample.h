// The dimensions of a photon path: which coordinate of u in [0,1)^D means what.
//
// Fixed layout: the emission's dimensions, then the same four for every scattering event, so that a
// small change of u is a small change of the path. A dimension is a 64-bit fraction of one turn,
// whose wrap-around is exact; it is read once or not at all, and an unread dimension is never
// drawn.
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
    hero,  // which wavelength a dispersive refraction keeps
    count
};
enum class BounceDimension : std::uint32_t { lobe, direction_u, direction_v, roulette, count };

constexpr std::uint32_t dimension(EmissionDimension which) {
    return static_cast<std::uint32_t>(which);
}

/// @param bounce  0 at the first surface that scatters the photon.
constexpr std::uint32_t dimension(std::uint32_t bounce, BounceDimension which) {
    return dimension(EmissionDimension::count) +
           bounce * static_cast<std::uint32_t>(BounceDimension::count) +
           static_cast<std::uint32_t>(which);
}

/// Does the dimension belong to how the photon leaves its light?
constexpr bool is_emission(std::uint32_t index) {
    return index < dimension(EmissionDimension::count);
}

/// Dimension i of a path's own stream. Of bounce dimensions no more than the highest 23 bits are
/// read, so each has one word, and all of a bounce share one random block; emission dimensions have
/// 64 bits.
constexpr std::uint64_t dimension_of(RandomStream& stream, std::uint32_t index) {
    if (is_emission(index)) return stream.at(index);
    constexpr std::uint32_t kEmissionDimensions = dimension(EmissionDimension::count);
    static_assert(2 * kEmissionDimensions % 4 == 0);
    return std::uint64_t{stream.word(index + kEmissionDimensions)} << 32U;
}

/// What a tracer sees of a primary sample: it names a dimension and gets its fraction, the same
/// each time. The samplers differ in nothing but their readers.
template <class R>
concept PrimarySampleReader = requires(R& read, std::uint32_t index) {
    { read(index) } -> std::same_as<std::uint64_t>;
};

/// Independent uniform dimensions, of the path's own stream.
class IndependentReader {
public:
    explicit IndependentReader(RandomStream stream) : stream_(stream) {}
    std::uint64_t operator()(std::uint32_t index) { return dimension_of(stream_, index); }

private:
    RandomStream stream_;
};

static_assert(PrimarySampleReader<IndependentReader>);

/// The primary samples of a pass's paths, all independent: the paper's uniform sampling.
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
