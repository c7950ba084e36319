// What blocks accept is what accepts() says, on every kind of processor that this one can stand
// for.
#include "visible_points/lookup.h"

#include "core/random.h"
#include "support/processor.h"

#include <algorithm>
#include <tuple>

namespace sunfleck::engine {
namespace {

constexpr int kMaxDepth = 5;

/// Points and photons on a wavy sheet, of all kinds, some seen from behind.
struct Sheet {
    RandomStream random{7, Purpose::test, 1, 0};

    Disc disc() {
        Disc disc;
        disc.position = {random.next_float(), random.next_float(), 0.02F * random.next_float()};
        disc.normal = normal();
        disc.radius = 0.01F + 0.1F * random.next_float();
        disc.indirect_radius_scale = 1 + random.next_float();
        disc.bounces = below(3);
        disc.kinds = static_cast<std::uint8_t>(below(16));
        disc.both_sides = random.next_float() < 0.3F;
        return disc;
    }

    Vec3 normal() {
        const Vec3 leaning(random.next_float() - 0.5F, random.next_float() - 0.5F, 0.7F);
        return leaning.normalized() * (random.next_float() < 0.2F ? -1.0F : 1.0F);
    }

    std::vector<VisiblePoint> points(std::size_t count) {
        std::vector<VisiblePoint> points(count);
        for (VisiblePoint& point : points) point.disc = disc();
        return points;
    }

    std::vector<PhotonChunk> photons(std::size_t count) {
        std::vector<PhotonChunk> chunks(3);
        for (std::size_t i = 0; i < count; ++i) {
            const Disc here = disc();
            Photon photon;
            photon.position = here.position;
            photon.normal = here.normal;
            photon.bounces = below(4);
            photon.kind = static_cast<PhotonKind>(1U << below(4));
            chunks[i % chunks.size()].add(photon, static_cast<std::uint32_t>(i));
        }
        return chunks;
    }

private:
    std::uint16_t below(std::uint32_t end) {
        return static_cast<std::uint16_t>(random.next_float() * static_cast<float>(end));
    }
};

using Pair = std::tuple<std::size_t, std::size_t>;  // photon, point

std::vector<Pair> looked_up(const VisiblePointIndex& index, const SortedPhotons& photons) {
    std::vector<Pair> pairs;
    TakenPhotons taken;
    for (std::size_t first = 0; first < index.block_count(); first += TakenPhotons::kBlocks) {
        const std::size_t end = std::min(index.block_count(), first + TakenPhotons::kBlocks);
        if (!find_taken(index, photons, first, end, taken)) continue;
        for (std::size_t block = first; block < end; ++block) {
            const TakenPhotons::Block& here = taken.blocks[block - first];
            unsigned all = 0;
            for (std::size_t t = here.first; t < here.first + here.count; ++t) {
                all |= taken.list[t].accepting;
                for (std::size_t i = 0; i < 8; ++i)
                    if ((taken.list[t].accepting >> i & 1U) != 0)
                        pairs.emplace_back(taken.list[t].photon, block * 8 + i);
            }
            EXPECT_EQ(here.accepting, all);
        }
    }
    return pairs;
}

std::vector<Pair> one_by_one(const VisiblePointIndex& index, const SortedPhotons& photons) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < photons.size(); ++i)
        for (std::size_t p = 0; p < index.points().size(); ++p)
            if (accepts(index.points()[p].disc, photons[i], kMaxDepth)) pairs.emplace_back(i, p);
    return pairs;
}

using Lookup = testing_support::OnProcessor;

TEST_P(Lookup, finds_what_the_gather_test_accepts) {
    Sheet sheet;
    for (const std::size_t count : {1U, 9U, 200U, 1500U}) {
        const VisiblePointIndex index({sheet.points(count)}, kMaxDepth);
        const SortedPhotons photons(sheet.photons(count), index.grid());
        std::vector<Pair> found = looked_up(index, photons);
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, one_by_one(index, photons)) << count;
        for (std::size_t i = 0; i < photons.size(); ++i) {
            const bool is_long_chain = photons[i].kind == PhotonKind::long_specular_chain;
            ASSERT_EQ(is_long_chain,
                      photons.widest_before(i + 1) == PhotonKind::long_specular_chain);
            const bool taken = std::any_of(found.begin(), found.end(), [&](const Pair& pair) {
                return std::get<0>(pair) == i;
            });
            ASSERT_EQ(index.any(photons[i]), taken);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, Lookup, testing_support::processors());

}  // namespace
}  // namespace sunfleck::engine
