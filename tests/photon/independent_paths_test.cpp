// Photon paths side by side are the paths one by one; what a pass counts of them.
#include "photon/independent_paths.h"

#include "random_numbers/emission_points.h"
#include "support/lantern.h"

#include <gtest/gtest.h>

#include <map>

namespace sunfleck::engine {
namespace {

using testing_support::lantern;

struct Seen {
    std::map<std::uint32_t, std::vector<Photon>> photons;  // by path, in their order
    Statistics statistics;
};

enum class Kind { random, uniform };

class IndependentPathsTest : public ::testing::TestWithParam<Kind> {
protected:
    /// One by one, by the tracer's plain loop.
    Seen expected(std::uint32_t count) const {
        Seen seen;
        for (std::uint32_t i = 0; i < count; ++i)
            if (GetParam() == Kind::uniform)
                trace(EmissionPoints(id_).path(i), i, seen);
            else
                trace(IndependentPoints(id_).path(i), i, seen);
        return seen;
    }

    template <class Reader>
    void trace(Reader read, std::uint32_t number, Seen& seen) const {
        const auto visit = [&](const Photon& photon) { seen.photons[number].push_back(photon); };
        const PathEnd end = tracer_.trace(read, visit, seen.statistics[Count::photon_rays]);
        seen.statistics[Count::escaped] += end == PathEnd::escaped ? 1 : 0;
        seen.statistics[Count::too_long] += end == PathEnd::too_long ? 1 : 0;
        ++seen.statistics[Count::uniform_paths];
    }

    /// Calls with the points of the kind.
    template <class Call>
    auto with_points(const Call& call) const {
        return GetParam() == Kind::uniform ? call(EmissionPoints(id_))
                                           : call(IndependentPoints(id_));
    }

    PassId id_{7, 2};
    Scene scene_{lantern()};
    PassScene pass_{scene_, id_};
    TransportSettings transport_{DirectLight::sampled, 8};
    PhotonTracer tracer_{pass_, transport_};
};

TEST_P(IndependentPathsTest, side_by_side_are_those_one_by_one) {
    for (const std::uint32_t count : {1U, 15U, 1300U}) {
        const Seen one_by_one = expected(count);
        Seen seen;
        const auto all = [](const Photon&) { return true; };
        const auto chunks = with_points([&](const auto& points) {
            return trace_chunks(tracer_, points, {0, count}, all);
        });
        for (const PhotonChunk& chunk : chunks) {
            for (std::size_t i = 0; i < chunk.photons.size(); ++i)
                seen.photons[chunk.paths[i]].push_back(chunk.photons[i]);
            seen.statistics += chunk.statistics;
        }
        seen.statistics[Count::uniform_paths] = count;
        EXPECT_EQ(seen.statistics, one_by_one.statistics);
        ASSERT_EQ(seen.photons.size(), one_by_one.photons.size());
        for (const auto& [path, photons] : one_by_one.photons) {
            ASSERT_EQ(seen.photons[path].size(), photons.size()) << path;
            for (std::size_t i = 0; i < photons.size(); ++i) {
                const Photon& photon = seen.photons[path][i];
                ASSERT_EQ(photon.position, photons[i].position);
                ASSERT_EQ(photon.w, photons[i].w);
                ASSERT_EQ(photon.flux, photons[i].flux);
                ASSERT_EQ(photon.kind, photons[i].kind);
                ASSERT_EQ(photon.bounces, photons[i].bounces);
            }
        }
    }
}

/// More paths than are traced at once; photons of the upper sheet are unwanted, those of the
/// lower sheet's left half are taken.
TEST_P(IndependentPathsTest, counts_the_visible_paths_and_keeps_what_is_wanted) {
    const auto count = static_cast<std::uint32_t>(paths_at_once(1) + 700);
    std::uint64_t visible = 0;
    const auto taken = [](const Photon& photon) { return photon.position.x < 0; };
    const auto wanted = [](const Photon& photon) { return photon.position.z < 0.5F; };
    const Seen one_by_one = expected(count);
    for (const auto& [path, photons] : one_by_one.photons)
        if (std::any_of(photons.begin(), photons.end(),
                        [&](const Photon& p) { return wanted(p) && taken(p); }))
            ++visible;
    std::size_t calls = 0;
    const auto deposit = [&](std::vector<PhotonChunk>& chunks) {
        ++calls;
        Statistics counted;
        for (PhotonChunk& chunk : chunks)
            for (std::size_t i = 0; i < chunk.photons.size(); ++i) {
                EXPECT_TRUE(wanted(chunk.photons[i]));
                chunk.taken[i] = taken(chunk.photons[i]) ? 1 : 0;
                counted[Count::photons_stored] += chunk.taken[i];
            }
        return counted;
    };
    const TracedPaths traced = with_points([&](const auto& points) {
        return trace_independent_paths(tracer_, points, count, wanted, deposit);
    });
    const Statistics& counted = traced.statistics;
    EXPECT_EQ(calls, 2U);
    EXPECT_EQ(traced.visible, visible);
    EXPECT_EQ(traced.visible_weight, static_cast<double>(visible));
    EXPECT_GT(counted[Count::photons_stored], visible);
    EXPECT_EQ(counted[Count::photon_rays], one_by_one.statistics[Count::photon_rays]);
    EXPECT_EQ(counted[Count::escaped], one_by_one.statistics[Count::escaped]);
    EXPECT_GT(counted[Count::too_long], 100U);
}

/// However many paths there are, what is seen is walked over eight times at most.
TEST(PathsAtOnce, are_few_deposits_of_many_paths) {
    for (const std::uint64_t count : {1ULL, 200'000ULL, 600'000ULL, 16'588'800ULL, 1ULL << 40U}) {
        const std::uint64_t at_once = paths_at_once(count);
        EXPECT_GE(at_once, 1U << 19U);
        EXPECT_LE((count + at_once - 1) / at_once, 8U);
        if (at_once > 1U << 19U) {
            EXPECT_GT((count + at_once - 1) / at_once, 4U);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(kinds, IndependentPathsTest,
                         ::testing::Values(Kind::random, Kind::uniform), [](const auto& info) {
                             return info.param == Kind::random ? "random" : "uniform";
                         });

}  // namespace
}  // namespace sunfleck::engine
