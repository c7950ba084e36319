// Uniform paths traced ahead, side by side, are to the chain what they are one by one.
#include "photon/paper_paths.h"

#include "photon/tracer.h"
#include "support/lantern.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// One path after the other, all their photons.
class PlainPhotons {
public:
    using Path = std::vector<Photon>;
    using Tally = Statistics;

    PlainPhotons(const PhotonTracer& tracer, const VisiblePointIndex& index)
        : tracer_(tracer), index_(index) {}

    template <PrimarySampleReader Reader>
    void trace(Reader&& read, Path& path, Statistics& counts) const {
        path.clear();
        const auto visit = [&](const Photon& photon) { path.push_back(photon); };
        count_end(tracer_.trace(read, visit, counts[Count::photon_rays]), counts);
    }
    int height(const Path& path) const { return index_.any(path) ? kVisible : 0; }

private:
    const PhotonTracer& tracer_;
    const VisiblePointIndex& index_;
};

/// Photons that are taken, copies counted each, and their flux.
struct Splats {
    std::uint64_t copies = 0;
    double flux = 0;

    void add(const VisiblePointIndex& index, const Photon& photon, std::uint32_t times) {
        if (!index.any(photon)) return;
        copies += times;
        flux += double{photon.flux.sum()};
    }
};

class PaperPaths : public ::testing::TestWithParam<bool> {
protected:
    /// A patch of the lower sheet, whose corner is at x.
    static std::vector<VisiblePoint> patch(float x) {
        std::vector<VisiblePoint> points;
        for (int i = 0; i < 64; ++i) {
            VisiblePoint point;
            point.disc.position = {x + 0.1F * static_cast<float>(i % 8),
                                   0.1F * static_cast<float>(i / 8), 0};
            point.disc.radius = 0.1F;
            point.disc.normal = {0, 0, 1};
            point.disc.kinds = 7;
            points.push_back(point);
        }
        return points;
    }

    /// Fig. 3 with the paths one by one. @return counts, without those of deposits.
    Statistics plain(const VisiblePointIndex& index, std::uint32_t paths, PaperState& state,
                     Splats& splats) const {
        const PlainPhotons space(tracer_, index);
        const IndependentPoints points(id_);
        Statistics counts;
        PaperChain<PlainPhotons> chain(space, GetParam(), state, id_.stream(Purpose::chain, 0),
                                       counts);
        const auto splat = [&](const std::vector<Photon>& path, std::uint32_t steps) {
            counts[Count::visible_states] += index.any(path) ? steps : 0;
            for (Photon photon : path) {
                photon.flux *= static_cast<float>(steps);
                splats.add(index, photon, steps);
            }
        };
        for (std::uint32_t i = 0; i < paths; ++i) {
            StoredSample read;
            std::vector<Photon> path;
            space.trace(RecordingReader(points.path(i), read), path, counts);
            const auto take = [&](StoredSample& sample, std::vector<Photon>& to) {
                sample = read;
                to = path;
            };
            const PaperStep step = chain.step(index.any(path), take, splat, counts);
            counts[Count::accepted_paths] += step == PaperStep::accepted ? 1 : 0;
        }
        chain.finish(splat);
        return counts;
    }

    PassId id_{7, 3};
    Scene scene_{testing_support::lantern()};
    PassScene pass_{scene_, id_};
    TransportSettings transport_{DirectLight::sampled, 8};
    PhotonTracer tracer_{pass_, transport_};
};

TEST_P(PaperPaths, are_those_of_a_plain_walk) {
    constexpr std::uint32_t kPaths = 5000;
    PaperState expected_state((PaperSettings()));
    PaperState state((PaperSettings()));
    Splats expected_splats;
    Splats splats;
    std::uint64_t unseen = 0;              // before the first path that is seen in a view
    for (const float x : {0.0F, -1.5F}) {  // the second goes on from the first, in another view
        const VisiblePointIndex index({patch(x)}, 8);
        const Statistics expected = plain(index, kPaths, expected_state, expected_splats);
        const auto deposit = [&](const std::vector<PhotonChunk>& chunks) {
            for (const PhotonChunk& chunk : chunks)
                for (const Photon& photon : chunk.photons) splats.add(index, photon, photon.copies);
            return Statistics();
        };
        const Statistics counts = trace_paper_paths({pass_, transport_, index},
                                                    {id_, kPaths, GetParam()}, state, deposit);
        for (const Count which : {Count::photon_rays, Count::escaped, Count::too_long,
                                  Count::accepted_paths, Count::visible_states})
            EXPECT_EQ(counts[which], expected[which]) << static_cast<int>(which);
        unseen += kPaths - counts[Count::visible_states];
        EXPECT_EQ(counts[Count::uniform_paths], kPaths);
    }
    EXPECT_GT(unseen, 2 * kPaths - state.splatted) << "in the second view, too";
    EXPECT_GT(state.uniform_visible, 100U);
    EXPECT_EQ(state.uniform_visible, expected_state.uniform_visible);
    EXPECT_EQ(state.splatted, expected_state.splatted);
    EXPECT_EQ(state.size.theta(), expected_state.size.theta());
    EXPECT_EQ(state.current, expected_state.current);
    EXPECT_GT(splats.copies, state.splatted);
    EXPECT_EQ(splats.copies, expected_splats.copies);
    EXPECT_NEAR(splats.flux / expected_splats.flux, 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(replica_exchange, PaperPaths, ::testing::Bool(),
                         [](const auto& info) { return info.param ? "on" : "off"; });

}  // namespace
}  // namespace sunfleck::engine
