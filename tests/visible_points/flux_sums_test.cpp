// Sums of flux are those of a plain loop, to the last bit, on every kind of processor.
#include "visible_points/flux_sums.h"

#include "core/random.h"
#include "support/processor.h"

#include <limits>

namespace sunfleck::engine {
namespace {

class FluxSums : public testing_support::OnProcessor {
protected:
    std::uint32_t below(std::uint32_t end) {
        return static_cast<std::uint32_t>(random_.next() * end);
    }

    SampledSpectrum spectrum() {
        SampledSpectrum s;
        for (float& lane : s.values) lane = random_.next_float();
        return s;
    }

    /// Of all kinds. No one accepts the last one, whose flux is no number.
    SortedPhotons photons(std::uint32_t count) {
        std::vector<PhotonChunk> chunks(1);
        for (std::uint32_t i = 0; i < count; ++i) {
            Photon photon;
            photon.position = Vec3(static_cast<float>(i), 0, 0);
            photon.kind = static_cast<PhotonKind>(1U << below(4));
            photon.flux = spectrum();
            if (i + 1 == count) {
                photon.kind = PhotonKind::long_specular_chain;  // and so the last one in order, too
                photon.flux = SampledSpectrum(std::numeric_limits<float>::quiet_NaN());
            }
            chunks[0].add(photon, i);
        }
        return {chunks, MortonGrid(Vec3(0), Vec3(static_cast<float>(count), 1, 1))};
    }

    std::vector<TakenPhoton> taken(std::uint32_t photons, std::uint32_t count) {
        std::vector<TakenPhoton> list;
        for (std::uint32_t i = 0; i < count; ++i) list.push_back({below(photons - 1), below(256)});
        list.push_back({photons - 1, 0});
        return list;
    }

    RandomStream random_{11, Purpose::test, 0, 0};
};

TEST_P(FluxSums, are_those_of_a_loop) {
    constexpr std::uint32_t kPhotons = 100;
    const SortedPhotons all = photons(kPhotons);
    for (const std::uint32_t count : {0U, 1U, 7U, 300U}) {
        const std::vector<TakenPhoton> list = taken(kPhotons, count);
        for (const PhotonKind kind : {PhotonKind::direct, PhotonKind::indirect}) {
            const std::uint32_t points = below(256);
            BlockLight expected;
            for (SampledSpectrum& light : expected) light = spectrum();
            BlockLight actual = expected;
            for (const TakenPhoton& t : list)
                for (std::size_t i = 0; i < expected.size(); ++i)
                    if (((t.accepting & points) >> i & 1U) != 0 && all[t.photon].kind == kind)
                        expected[i] += all[t.photon].flux;
            add_flux(all, list, kind, points, actual);
            EXPECT_EQ(actual, expected) << count;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, FluxSums, testing_support::processors());

}  // namespace
}  // namespace sunfleck::engine
