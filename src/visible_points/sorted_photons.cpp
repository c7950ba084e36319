// Sorting, copying, and construction of the tree.
#include "visible_points/sorted_photons.h"

#include "core/parallel.h"
#include "visible_points/morton_order.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace sunfleck::engine {
namespace {

bool is_long_chain(const Photon& photon) {
    return photon.kind == PhotonKind::long_specular_chain;
}

/// Returns all photons of the chunks in order, long specular chains last.
MortonKeys in_order(const std::vector<PhotonChunk>& chunks, const MortonGrid& grid) {
    constexpr unsigned kSortedBits = 33;
    return in_morton_order(
        chunks.size(), [&](std::size_t b) { return chunks[b].photons.size(); },
        [&](std::size_t b, std::size_t i) {
            const Photon& photon = chunks[b].photons[i];
            const std::uint64_t is_last = is_long_chain(photon) ? 1 : 0;
            return grid.code(photon.position) >> 1U | is_last << 62U;
        },
        kSortedBits);
}

void call_into_cache(const std::vector<PhotonChunk>& chunks, const MortonKey& key) {
    const Photon& photon = chunks[key.list].photons[key.item];
    __builtin_prefetch(&photon);
    __builtin_prefetch(&photon.flux.values.back());
}

}  // namespace

SortedPhotons::SortedPhotons(const std::vector<PhotonChunk>& chunks, const MortonGrid& grid)
    : order_(in_order(chunks, grid)),
      photons_(order_.size()),
      leaves_((order_.size() + kWidth - 1) / kWidth) {
    constexpr std::size_t kBlock = 512;
    constexpr std::size_t kAhead = 8;
    std::vector<Box> boxes(leaves_.size());
    parallel_blocks(leaves_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        const std::size_t last = std::min(end * kWidth, order_.size());
        for (std::size_t i = begin * kWidth; i < last; ++i) {
            if (i + kAhead < last) call_into_cache(chunks, order_[i + kAhead]);
            photons_[i] = chunks[order_[i].list].photons[order_[i].item];
        }
        for (std::size_t leaf = begin; leaf < end; ++leaf) boxes[leaf] = fill(leaf);
    });
    tree_ = BoxTree(std::move(boxes));
    first_deep_ = static_cast<std::size_t>(
        std::partition_point(photons_.begin(), photons_.end(), std::not_fn(is_long_chain)) -
        photons_.begin());
}

Box SortedPhotons::fill(std::size_t leaf) {
    Box box;
    for (std::size_t i = 0; i < kWidth; ++i) {
        const bool exists = leaf * kWidth + i < photons_.size();
        Vec3 position(std::numeric_limits<float>::quiet_NaN());
        if (exists) position = photons_[leaf * kWidth + i].position;
        if (exists) box.extend({position, position});
        for (int c = 0; c < 3; ++c)
            leaves_[leaf].position.at(static_cast<std::size_t>(c)).at(i) = position[c];
    }
    return box;
}

void SortedPhotons::hand_back(const std::vector<std::uint8_t>& taken,
                              std::vector<PhotonChunk>& chunks) const {
    constexpr std::size_t kBlock = 16384;
    parallel_blocks(order_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            chunks[order_[i].list].taken[order_[i].item] = taken[i];
    });
}

}  // namespace sunfleck::engine
