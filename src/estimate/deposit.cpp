// Deposits of many photons at once: every block of eight visible points gathers its photons.
#include "estimate/deposit.h"

#include "core/parallel.h"
#include "estimate/gatherer.h"

namespace sunfleck::engine {

Statistics Depositor::operator()(std::vector<PhotonChunk>& chunks) const {
    constexpr std::size_t kBlocks = 256;
    const SortedPhotons photons(chunks, index_.grid());
    VisibleFlags taken(photons.size());
    PixelLocks locks;
    const GatherContext all{pass_, index_, image_, paths_, counts_, photons, taken, locks};
    std::atomic<std::uint64_t> deposits{0};
    parallel_blocks(index_.block_count(), kBlocks, [&](std::size_t begin, std::size_t end) {
        std::uint64_t sum = 0;
        Gatherer gatherer(all);
        for (std::size_t first = begin; first < end; first += Gatherer::kTogether)
            sum += gatherer.gather(first, std::min(end, first + Gatherer::kTogether));
        gatherer.finish();
        deposits.fetch_add(sum, std::memory_order_relaxed);
    });
    photons.hand_back(taken.all(), chunks);
    Statistics total;
    total[Count::deposits] = deposits;
    total[Count::photons_stored] = static_cast<std::uint64_t>(
        std::count(taken.all().begin(), taken.all().end(), std::uint8_t{1}));
    return total;
}

}  // namespace sunfleck::engine
