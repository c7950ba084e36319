// Gatherer: blocks of visible points gather the photons that they accept.
//
// In:  sorted photons, an index of visible points. Out: terms of pixels, marks at accepted photons.
// A few blocks that are close in space are processed together: all of them look up their photons
// and prefetch what the sums read, then all of them sum up.
#pragma once

#include "aovs/pass_image.h"
#include "estimate/photon_counts.h"
#include "estimate/photon_terms.h"
#include "estimate/shared_terms.h"
#include "visible_points/flux_sums.h"
#include "visible_points/lookup.h"
#include "visible_points/sight.h"
#include "visible_points/visible_point_index.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <span>

namespace sunfleck::engine {

inline constexpr std::array<PhotonKind, 4> kKinds = {
    PhotonKind::direct, PhotonKind::caustic, PhotonKind::indirect, PhotonKind::long_specular_chain};

inline std::size_t number_of(PhotonKind kind) {
    return static_cast<std::size_t>(__builtin_ctz(static_cast<unsigned>(kind)));
}

/// Visible flags that several threads may set at once.
class VisibleFlags {
public:
    explicit VisibleFlags(std::size_t count) : marks_(count, 0) {}
    void set(std::size_t i) {
        std::atomic_ref<std::uint8_t> mark(marks_[i]);
        if (mark.load(std::memory_order_relaxed) == 0) mark.store(1, std::memory_order_relaxed);
    }
    const std::vector<std::uint8_t>& all() const { return marks_; }

private:
    std::vector<std::uint8_t> marks_;
};

/// Data that all blocks share.
struct GatherContext {
    const PassScene& pass;
    const VisiblePointIndex& index;
    PassImage& image;
    std::uint32_t paths;
    PhotonCounts* counts;  // or null
    const SortedPhotons& photons;
    VisibleFlags& taken;
    PixelLocks& locks;
};

/// Sums of light by kind and point, block by block.
class Gatherer {
public:
    static constexpr std::size_t kTogether = TakenPhotons::kBlocks;
    static constexpr std::size_t kPoints = VisiblePointIndex::kWidth;  // per block

    explicit Gatherer(const GatherContext& all) : all_(all), shared_(all.image, all.locks) {}

    /// Gathers for blocks begin .. end - 1, at most kTogether, close in space.
    /// @return the number of accepted photons times accepting points.
    std::uint64_t gather(std::size_t begin, std::size_t end) {
        if (!find_taken(all_.index, all_.photons, begin, end, taken_)) return 0;
        for (std::size_t b = begin; b < end; ++b) leave_hidden_out(b, taken_.blocks[b - begin]);
        for (std::size_t b = begin; b < end; ++b)
            call_points(b, taken_.blocks[b - begin].accepting);
        for (std::size_t b = begin; b < end; ++b)
            call_pixels(b, taken_.blocks[b - begin].accepting);
        std::uint64_t deposits = 0;
        for (block_ = begin; block_ < end; ++block_)
            deposits += sum_up(taken_.blocks[block_ - begin]);
        return deposits;
    }

    /// Adds the remaining terms to the image; it is called once, last.
    void finish() { shared_.flush(); }

private:
    const VisiblePoint& point(std::size_t i) const { return point(block_, i); }
    const VisiblePoint& point(std::size_t block, std::size_t i) const {
        return all_.index.points()[block * kPoints + i];
    }

    std::size_t points_here() const {
        return std::min(kPoints, all_.index.points().size() - block_ * kPoints);
    }

    /// Prefetches what sum_up() reads of the points. @param accepting  bit mask.
    void call_points(std::size_t block, unsigned accepting) const {
        for (; accepting != 0; accepting &= accepting - 1) {
            const VisiblePoint& to = point(block, static_cast<unsigned>(__builtin_ctz(accepting)));
            __builtin_prefetch(&to.throughput);
            __builtin_prefetch(&to.pixel);
        }
    }

    /// Prefetches the points' pixels.
    void call_pixels(std::size_t block, unsigned accepting) const {
        for (; accepting != 0; accepting &= accepting - 1) {
            const VisiblePoint& to = point(block, static_cast<unsigned>(__builtin_ctz(accepting)));
            if (!to.shares_pixel) __builtin_prefetch(all_.image.place_of(to.pixel), 1);
        }
    }

    /// Leaves out photons of points that need sight and do not see them.
    void leave_hidden_out(std::size_t block, const TakenPhotons::Block& found) {
        const unsigned need_sight = all_.index.need_sight(block);
        if (need_sight == 0) return;
        for (std::size_t k = found.first; k < found.first + found.count; ++k) {
            TakenPhoton& taken = taken_.list[k];
            const Photon& photon = all_.photons[taken.photon];
            for (unsigned rest = taken.accepting & need_sight; rest != 0; rest &= rest - 1) {
                const auto i = static_cast<unsigned>(__builtin_ctz(rest));
                const Disc& disc = point(block, i).disc;
                if (disc.is_probed_for(photon.kind) &&
                    !sees(all_.pass.scene.geometry(), disc, photon))
                    taken.accepting &= ~(1U << i);
            }
        }
    }

    std::uint64_t sum_up(const TakenPhotons::Block& found) {
        if (found.count == 0) return 0;
        plain_ = all_.index.plain(block_);
        here_ = {&taken_.list[found.first], found.count};
        std::array<unsigned, kKinds.size()> met{};  // points that accepted a photon of the kind
        std::uint64_t deposits = 0;
        for (const TakenPhoton& taken : here_) {
            if (taken.accepting == 0) continue;
            const Photon& photon = all_.photons[taken.photon];
            const std::size_t kind = number_of(photon.kind);
            all_.taken.set(taken.photon);
            met[kind] |= taken.accepting;
            deposits += static_cast<unsigned>(__builtin_popcount(taken.accepting));
            for (unsigned rest = taken.accepting & ~plain_; rest != 0; rest &= rest - 1) {
                const auto i = static_cast<unsigned>(__builtin_ctz(rest));
                light_[kind][i] += light_of(all_.pass, point(i), photon);
            }
        }
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
            if ((met[kind] & plain_) != 0)
                add_flux(all_.photons, here_, kKinds[kind], plain_, light_[kind]);
            for (unsigned rest = met[kind]; rest != 0; rest &= rest - 1)
                finish_point(static_cast<unsigned>(__builtin_ctz(rest)), kKinds[kind]);
        }
        if (all_.image.light_groups() > 0) add_to_light_groups();
        if (all_.counts != nullptr) count(*all_.counts);
        return deposits;
    }

    /// Adds the same light to the light groups.
    void add_to_light_groups() const {
        std::array<std::uint64_t, kKinds.size()> groups{};  // by kind: a bit per group
        for (const TakenPhoton& taken : here_) {
            const Photon& photon = all_.photons[taken.photon];
            if (photon.light_group != kNoLightGroup)
                groups[number_of(photon.kind)] |= std::uint64_t{1} << photon.light_group;
        }
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
            for (std::uint64_t rest = groups[kind]; rest != 0; rest &= rest - 1)
                add_to_light_group(static_cast<std::uint8_t>(__builtin_ctzll(rest)), kKinds[kind]);
    }

    void add_to_light_group(std::uint8_t group, PhotonKind kind) const {
        BlockLight light{};
        unsigned met = 0;
        for (const TakenPhoton& taken : here_) {
            const Photon& photon = all_.photons[taken.photon];
            if (photon.light_group != group || photon.kind != kind) continue;
            met |= taken.accepting;
            for (unsigned rest = taken.accepting; rest != 0; rest &= rest - 1)
                add(static_cast<unsigned>(__builtin_ctz(rest)), photon, light);
        }
        for (; met != 0; met &= met - 1) {
            const auto i = static_cast<unsigned>(__builtin_ctz(met));
            const SampledSpectrum share = this->share(i, kind);
            all_.image.add_to_light_group(point(i).pixel,
                                          all_.pass.wavelengths.to_rgb(light[i] * share), group);
        }
    }

    SampledSpectrum share(std::size_t i, PhotonKind kind) const {
        return share_of(point(i), kind, all_.index.radius(block_, i, kind), all_.paths);
    }

    void add(std::size_t i, const Photon& photon, BlockLight& light) const {
        if ((plain_ >> i & 1U) != 0)
            light[i] += photon.flux;
        else
            light[i] += light_of(all_.pass, point(i), photon);
    }

    /// Adds the sum of a point to its pixel, and resets it for the next block.
    void finish_point(std::size_t i, PhotonKind kind) {
        const VisiblePoint& to = point(i);
        const SampledSpectrum share = this->share(i, kind);
        SampledSpectrum& light = light_[number_of(kind)][i];
        const Vec3 rgb = all_.pass.wavelengths.to_rgb(light * share);
        light = SampledSpectrum();
        if (!PassImage::is_addable(rgb))
            add_one_by_one(i, kind, share);
        else if (to.shares_pixel)
            shared_.add({rgb, to.pixel, owner_of(to, kind)});
        else
            all_.image.add_alone(to.pixel, rgb, owner_of(to, kind));
    }

    /// Adds photons one by one if their sum is not finite, so that only faulty ones are dropped.
    void add_one_by_one(std::size_t i, PhotonKind kind, const SampledSpectrum& share) const {
        const std::lock_guard<std::mutex> guard(all_.locks.of_pixel(point(i).pixel));
        for (const TakenPhoton& taken : here_) {
            const Photon& photon = all_.photons[taken.photon];
            if (photon.kind != kind || (taken.accepting >> i & 1U) == 0) continue;
            const SampledSpectrum value = light_of(all_.pass, point(i), photon) * share;
            all_.image.add_light(point(i).pixel, all_.pass.wavelengths.to_rgb(value),
                                 owner_of(point(i), kind));
        }
    }

    /// Adds the accepted photons of the points to the counts of their pixels.
    void count(PhotonCounts& counts) const {
        std::array<std::uint64_t, kPoints> copies{};
        for (const TakenPhoton& taken : here_)
            for (unsigned rest = taken.accepting; rest != 0; rest &= rest - 1)
                copies[static_cast<unsigned>(__builtin_ctz(rest))] +=
                    all_.photons[taken.photon].copies;
        for (std::size_t i = 0; i < points_here(); ++i)
            if (copies[i] != 0)
                counts[point(i).pixel].fetch_add(copies[i], std::memory_order_relaxed);
    }

    const GatherContext& all_;
    SharedTerms shared_;
    TakenPhotons taken_;
    std::size_t block_ = 0;
    std::span<const TakenPhoton> here_;            // of the current block
    unsigned plain_ = 0;                           // points whose light is the photons' flux
    std::array<BlockLight, kKinds.size()> light_;  // zero between blocks
};

}  // namespace sunfleck::engine
