// Deposits of many photons at once: every block of eight visible points gathers its photons.
#include "estimate/deposit.h"

#include "core/parallel.h"
#include "measurement/sorted_photons.h"

#include <algorithm>
#include <mutex>

namespace sunfleck {
namespace {

constexpr std::size_t kWidth = VisiblePointIndex::kWidth;
constexpr std::array<PhotonKind, 3> kKinds = {PhotonKind::direct, PhotonKind::caustic,
                                              PhotonKind::indirect};

std::size_t number_of(PhotonKind kind) {
    return static_cast<std::size_t>(__builtin_ctz(static_cast<unsigned>(kind)));
}

/// Marks that several threads may set at once.
class Marks {
public:
    explicit Marks(std::size_t count) : marks_(count, 0) {}
    void set(std::size_t i) {
        std::atomic_ref<std::uint8_t> mark(marks_[i]);
        if (mark.load(std::memory_order_relaxed) == 0) mark.store(1, std::memory_order_relaxed);
    }
    const std::vector<std::uint8_t>& all() const { return marks_; }

private:
    std::vector<std::uint8_t> marks_;
};

/// What all blocks share.
struct Gathering {
    const PassScene& pass;
    const VisiblePointIndex& index;
    PassImage& image;
    std::uint32_t paths;
    PhotonCounts* counts;  // or none
    const SortedPhotons& photons;
    Marks& taken;
};

/// Blocks of visible points one after the other: sums of light by kind and point.
class Gatherer {
public:
    explicit Gatherer(const Gathering& all) : all_(all) {}

    /// Blocks begin .. end - 1, neighbours in space. @return photons times points that took them.
    std::uint64_t gather(std::size_t begin, std::size_t end) {
        Box box;
        for (std::size_t block = begin; block < end; ++block) box.extend(all_.index.box(block));
        all_.photons.find_places(box, places_);
        std::uint64_t deposits = 0;
        for (block_ = begin; block_ < end; ++block_) deposits += gather_block();
        return deposits;
    }

private:
    struct Taken {
        std::size_t photon;
        unsigned takers;  // bit i: point i of the block
    };

    const VisiblePoint& point(std::size_t i) const {
        return all_.index.points()[block_ * kWidth + i];
    }

    std::size_t points_here() const {
        return std::min(kWidth, all_.index.points().size() - block_ * kWidth);
    }

    std::uint64_t gather_block() {
        plain_ = all_.index.plain(block_);
        call_ahead();
        find_taken();
        if (count_ == 0) return 0;
        std::array<unsigned, kKinds.size()> met{};  // points that took a photon of the kind
        std::uint64_t deposits = 0;
        for (std::size_t t = 0; t < count_; ++t) {
            const Photon& photon = all_.photons[taken_[t].photon];
            const std::size_t kind = number_of(photon.kind);
            all_.taken.set(taken_[t].photon);
            met[kind] |= taken_[t].takers;
            deposits += static_cast<unsigned>(__builtin_popcount(taken_[t].takers));
            for (unsigned rest = taken_[t].takers; rest != 0; rest &= rest - 1)
                add(static_cast<unsigned>(__builtin_ctz(rest)), photon, light_[kind]);
        }
        for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
            for (unsigned rest = met[kind]; rest != 0; rest &= rest - 1)
                finish(static_cast<unsigned>(__builtin_ctz(rest)), kKinds[kind]);
        if (all_.image.light_layers() > 0) add_to_light_layers();
        if (all_.counts != nullptr) count(*all_.counts);
        return deposits;
    }

    /// The same light again, by the layers of the lights that it comes from.
    void add_to_light_layers() const {
        std::uint64_t layers = 0;
        for (std::size_t t = 0; t < count_; ++t) {
            const std::uint8_t layer = all_.photons[taken_[t].photon].light_layer;
            if (layer != kNoLightLayer) layers |= std::uint64_t{1} << layer;
        }
        for (; layers != 0; layers &= layers - 1)
            add_to_light_layer(static_cast<std::uint8_t>(__builtin_ctzll(layers)));
    }

    void add_to_light_layer(std::uint8_t layer) const {
        Lights light{};
        unsigned met = 0;
        for (std::size_t t = 0; t < count_; ++t) {
            const Photon& photon = all_.photons[taken_[t].photon];
            if (photon.light_layer != layer) continue;
            met |= taken_[t].takers;
            for (unsigned rest = taken_[t].takers; rest != 0; rest &= rest - 1)
                add(static_cast<unsigned>(__builtin_ctz(rest)), photon, light);
        }
        for (; met != 0; met &= met - 1) {
            const auto i = static_cast<unsigned>(__builtin_ctz(met));
            const Spectrum share = share_of(point(i), all_.index.radius(block_, i), all_.paths);
            all_.image.add_to_light_layer(point(i).pixel,
                                          all_.pass.wavelengths.to_rgb(light[i] * share), layer);
        }
    }

    /// Calls into the cache what the next blocks will need: the points of the one after next (the
    /// line that finish() reads), and the pixels of the next, whose points are there by now.
    void call_ahead() const {
        const std::vector<VisiblePoint>& points = all_.index.points();
        const std::size_t next = (block_ + 1) * kWidth;
        if (next + 2 * kWidth > points.size()) return;
        for (std::size_t i = 0; i < kWidth; ++i) {
            __builtin_prefetch(&points[next + kWidth + i].pixel);
            __builtin_prefetch(all_.image.place_of(points[next + i].pixel), 1);
        }
    }

    /// Lists the photons that the block takes.
    void find_taken() {
        count_ = 0;
        all_.photons.in_box(all_.index.box(block_), places_, [&](std::size_t i) {
            if (count_ == taken_.size()) taken_.resize(2 * count_ + 64);
            const unsigned takers = all_.index.takers(block_, all_.photons[i]);
            taken_[count_] = {i, takers};
            count_ += takers != 0 ? 1 : 0;
        });
    }

    using Lights = std::array<Spectrum, kWidth>;

    void add(std::size_t i, const Photon& photon, Lights& light) const {
        if ((plain_ >> i & 1U) != 0)
            light[i] += photon.flux;
        else
            light[i] += light_of(all_.pass, point(i), photon);
    }

    /// Adds the point's sum to its pixel, and makes it zero for the next block.
    void finish(std::size_t i, PhotonKind kind) {
        const VisiblePoint& to = point(i);
        const Spectrum share = share_of(to, all_.index.radius(block_, i), all_.paths);
        Spectrum& light = light_[number_of(kind)][i];
        const Vec3 rgb = all_.pass.wavelengths.to_rgb(light * share);
        light = Spectrum();
        if (PassImage::is_addable(rgb))
            all_.image.add_addable(to.pixel, rgb, owner_of(to, kind), !to.shares_pixel);
        else
            add_one_by_one(i, kind, share);
    }

    /// Where the sum is not a number that can be added: each photon stands or falls by itself.
    void add_one_by_one(std::size_t i, PhotonKind kind, const Spectrum& share) const {
        for (std::size_t t = 0; t < count_; ++t) {
            const Photon& photon = all_.photons[taken_[t].photon];
            if (photon.kind != kind || (taken_[t].takers >> i & 1U) == 0) continue;
            const Spectrum value = light_of(all_.pass, point(i), photon) * share;
            all_.image.add_light(point(i).pixel, all_.pass.wavelengths.to_rgb(value),
                                 owner_of(point(i), kind));
        }
    }

    /// Adds what the points have taken to the counts of their pixels.
    void count(PhotonCounts& counts) const {
        std::array<std::uint64_t, kWidth> taken{};
        for (std::size_t t = 0; t < count_; ++t)
            for (unsigned rest = taken_[t].takers; rest != 0; rest &= rest - 1)
                taken[static_cast<unsigned>(__builtin_ctz(rest))] +=
                    all_.photons[taken_[t].photon].copies;
        for (std::size_t i = 0; i < points_here(); ++i)
            if (taken[i] != 0)
                counts[point(i).pixel].fetch_add(taken[i], std::memory_order_relaxed);
    }

    const Gathering& all_;
    SortedPhotons::Places places_;
    std::vector<Taken> taken_;  // the first count_
    std::size_t count_ = 0;
    std::size_t block_ = 0;
    unsigned plain_ = 0;                       // points whose light is the photons' flux
    std::array<Lights, kKinds.size()> light_;  // all zero between blocks
};

}  // namespace

Statistics Depositor::operator()(std::vector<PhotonBatch>& batches) const {
    constexpr std::size_t kBlocks = 256;
    constexpr std::size_t kNeighbours = 8;
    const SortedPhotons photons(batches, index_.grid());
    Marks taken(photons.size());
    const Gathering all{pass_, index_, image_, paths_, counts_, photons, taken};
    std::atomic<std::uint64_t> deposits{0};
    parallel_blocks(index_.block_count(), kBlocks, [&](std::size_t begin, std::size_t end) {
        std::uint64_t sum = 0;
        Gatherer gatherer(all);
        for (std::size_t first = begin; first < end; first += kNeighbours)
            sum += gatherer.gather(first, std::min(end, first + kNeighbours));
        deposits.fetch_add(sum, std::memory_order_relaxed);
    });
    photons.hand_back(taken.all(), batches);
    Statistics total;
    total[Count::deposits] = deposits;
    total[Count::photons_stored] = static_cast<std::uint64_t>(
        std::count(taken.all().begin(), taken.all().end(), std::uint8_t{1}));
    return total;
}

}  // namespace sunfleck
