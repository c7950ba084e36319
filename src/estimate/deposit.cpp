// Deposits of many photons at once: sorted along the Morton curve of the index, then in parallel.
#include "estimate/deposit.h"

#include "core/parallel.h"

#include <mutex>

namespace sunfleck {
namespace {

/// All photons of the batches in Morton order.
std::vector<MortonKey> in_order(const std::vector<PhotonBatch>& batches, const MortonGrid& grid) {
    constexpr unsigned kSortedBits = 33;
    std::vector<std::size_t> first(batches.size() + 1, 0);
    for (std::size_t b = 0; b < batches.size(); ++b)
        first[b + 1] = first[b] + batches[b].photons.size();
    std::vector<MortonKey> keys(first.back());
    parallel_for(batches.size(), [&](std::size_t b) {
        const std::vector<Photon>& photons = batches[b].photons;
        for (std::size_t i = 0; i < photons.size(); ++i)
            keys[first[b] + i] = {grid.code(photons[i].position), static_cast<std::uint32_t>(i),
                                  static_cast<std::uint32_t>(b)};
    });
    sort_by_code(keys, kSortedBits);
    return keys;
}

}  // namespace

Statistics Depositor::operator()(std::vector<PhotonBatch>& batches) const {
    constexpr std::size_t kBlock = 4096;
    constexpr std::size_t kAhead = 8;
    const std::vector<MortonKey> order = in_order(batches, index_.grid());
    Statistics total;
    std::mutex guard;
    parallel_blocks(order.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        Statistics block;
        for (std::size_t i = begin; i < end; ++i) {
            if (i + kAhead < end) {
                const MortonKey& next = order[i + kAhead];
                __builtin_prefetch(&batches[next.list].photons[next.item]);
            }
            PhotonBatch& batch = batches[order[i].list];
            const std::uint32_t item = order[i].item;
            batch.taken[item] = deposit(batch.photons[item], block) ? 1 : 0;
        }
        const std::lock_guard lock(guard);
        total += block;
    });
    return total;
}

}  // namespace sunfleck
