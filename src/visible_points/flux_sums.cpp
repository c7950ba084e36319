// Compiled once for each kind of processor; the first call picks one.
//
// All eight sums stay in registers while the list goes by. Each photon is added to all of them,
// with zeros in place of its flux where it is not taken: no branch, of which none could be
// foreseen.
#include "visible_points/flux_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visible_points/flux_sums.cpp"
// No wider than the eight lanes of a spectrum.
#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL | HWY_SSE4)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sunfleck::engine::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kWavelengths>;
using Integers = hn::RebindToSigned<Floats>;
using Vector = hn::Vec<Floats>;
constexpr std::size_t kAtOnce = hn::MaxLanes(Floats());

/// Of which photons, and for whom.
struct Wanted {
    PhotonKind kind;
    unsigned points;  // bits
};

/// Of the lanes from `first` on, kAtOnce of them.
HWY_INLINE void add_lanes(const SortedPhotons& photons, std::span<const TakenPhoton> taken,
                          const Wanted& wanted, std::size_t first, BlockLight& light) {
    const Floats tag;
    const Integers numbers;
    const auto load = [&](std::size_t i)
                          HWY_ATTR { return hn::LoadU(tag, &light[i].values[first]); };
    Vector s0 = load(0);
    Vector s1 = load(1);
    Vector s2 = load(2);
    Vector s3 = load(3);
    Vector s4 = load(4);
    Vector s5 = load(5);
    Vector s6 = load(6);
    Vector s7 = load(7);
    for (const TakenPhoton& t : taken) {
        const Photon& photon = photons[t.photon];
        const unsigned accepting = photon.kind == wanted.kind ? t.accepting & wanted.points : 0;
        const Vector flux = hn::LoadU(tag, &photon.flux.values[first]);
        const auto by = hn::Set(numbers, static_cast<std::int32_t>(accepting));
        const auto part = [&](std::int32_t bit) HWY_ATTR {
            const auto accepts = hn::TestBit(by, hn::Set(numbers, bit));
            return hn::IfThenElseZero(hn::RebindMask(tag, accepts), flux);
        };
        s0 = hn::Add(s0, part(1));
        s1 = hn::Add(s1, part(2));
        s2 = hn::Add(s2, part(4));
        s3 = hn::Add(s3, part(8));
        s4 = hn::Add(s4, part(16));
        s5 = hn::Add(s5, part(32));
        s6 = hn::Add(s6, part(64));
        s7 = hn::Add(s7, part(128));
    }
    const std::array<Vector, 8> sums = {s0, s1, s2, s3, s4, s5, s6, s7};
    for (std::size_t i = 0; i < sums.size(); ++i) hn::StoreU(sums[i], tag, &light[i].values[first]);
}

void add_flux(const SortedPhotons& photons, std::span<const TakenPhoton> taken, PhotonKind kind,
              unsigned points, BlockLight& light) {
    for (std::size_t first = 0; first < kWavelengths; first += kAtOnce)
        add_lanes(photons, taken, {kind, points}, first, light);
}

}  // namespace sunfleck::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sunfleck::engine {

HWY_EXPORT(add_flux);

void add_flux(const SortedPhotons& photons, std::span<const TakenPhoton> taken, PhotonKind kind,
              unsigned points, BlockLight& light) {
    HWY_DYNAMIC_DISPATCH(add_flux)(photons, taken, kind, points, light);
}

}  // namespace sunfleck::engine
#endif
