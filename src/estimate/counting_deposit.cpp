// Photon after photon, each to all points that take it.
#include "estimate/counting_deposit.h"

#include "core/parallel.h"

namespace sunfleck {

Statistics CountingDeposit::operator()(const RepeatedPhotons& photons) const {
    std::atomic<std::uint64_t> stored{0};
    std::atomic<std::uint64_t> deposits{0};
    parallel_blocks(photons.photons.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Photon& photon = photons.photons[i];
            const std::uint32_t times = photons.repeats[i];
            std::uint64_t takers = 0;
            index.for_each(photon, [&](const VisiblePoint& point) {
                const Spectrum light = light_of(pass, point, photon) * share_of(point, paths);
                image.add_light(point.pixel,
                                pass.wavelengths.to_rgb(light * static_cast<float>(times)),
                                owner_of(point, photon.kind));
                taken[point.pixel].fetch_add(times, std::memory_order_relaxed);
                ++takers;
            });
            deposits.fetch_add(takers, std::memory_order_relaxed);
            stored.fetch_add(takers > 0 ? 1 : 0, std::memory_order_relaxed);
        }
    });
    Statistics counts;
    counts[Count::photons_stored] = stored;
    counts[Count::deposits] = deposits;
    return counts;
}

}  // namespace sunfleck
