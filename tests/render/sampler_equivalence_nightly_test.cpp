// The samplers agree on whole scenes at equal radii, block by block: of the ratio of brightness
// with `adaptive` over that with `random` and with `uniform`, the 99% interval lies inside the band
// that each scene states. Renders are batches of 16 passes, each with a seed that all samplers
// share: so they share camera rays and direct light, whose noise falls out of the ratio. `random`
// brings the noise that is left: about 1 / sqrt(visible paths), which sets the numbers of renders
// (3.2 hours of one core in all).
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kPasses = 16;

struct Case {
    std::string scene;
    int blocks;  // each way
    double band;
    int renders;
};

/// Of a test's name.
std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.scene;
}

class SamplerEquivalence : public testing::TestWithParam<Case> {
protected:
    static constexpr int kBlock = 8;

    static Scene scene() {
        const int size = kBlock * GetParam().blocks;
        if (GetParam().scene == "two-islands") return two_islands(size);
        return procedural(GetParam().scene, size);
    }

    /// A floor under a roof with two small holes far apart, each with a lamp of its own above it:
    /// the paths through one are no neighbours of those through the other.
    static Scene two_islands(int n) {
        const std::string lamp = "AreaLightSource \"diffuse\" \"rgb L\" [9 9 9]\n";
        const std::string roof =
            quad("-4 -4 1  -4 4 1  -.8 4 1  -.8 -4 1") +
            quad("-.4 -4 1  -.4 4 1  .4 4 1  .4 -4 1") + quad(".6 -4 1  .6 4 1  4 4 1  4 -4 1") +
            quad("-.8 -4 1  -.8 0 1  .6 0 1  .6 -4 1") + quad("-.8 .3 1  -.8 4 1  .6 4 1  .6 .3 1");
        return scene_of(view("0 0 .9  0 0 0  0 1 0", 60, n) + diffuse("0.5 0.5 0.5") +
                        quad("-4 -4 0  4 -4 0  4 4 0  -4 4 0") + roof + "AttributeBegin\n" + lamp +
                        quad("-2 -1 2  -2 1 2  -1 1 2  -1 -1 2") + "AttributeEnd\n" + lamp +
                        quad("1 -1 2  1 1 2  2.5 1 2  2.5 -1 2"));
    }

    /// Brightness of one block, by render.
    using Values = std::vector<double>;

    std::vector<Values> blocks(const Scene& scene, PhotonSampler sampler) const {
        const int blocks = GetParam().blocks;
        std::vector<Values> values(static_cast<std::size_t>(blocks * blocks));
        RenderSettings settings;
        settings.photon.sampler = sampler;
        settings.photon.adaptive_pixels = false;  // which `adaptive` alone has: camera rays differ
        for (int i = 0; i < GetParam().renders; ++i) {
            settings.seed = static_cast<std::uint64_t>(i);
            const MeanPicture picture = render_mean(scene, settings, kPasses);
            for (int b = 0; b < blocks * blocks; ++b) {
                const int x = b % blocks * kBlock;
                const int y = b / blocks * kBlock;
                values[static_cast<std::size_t>(b)].push_back(
                    luminance(picture.mean(x, y, x + kBlock, y + kBlock)));
            }
        }
        return values;
    }

    /// Mean a over mean b, with its standard error: that of a - ratio * b, whose mean is zero.
    static Estimate ratio(const Values& a, const Values& b) {
        const double above = Estimate::of(a).mean;
        const double below = Estimate::of(b).mean;
        Values rest;
        for (std::size_t i = 0; i < a.size(); ++i) rest.push_back(a[i] - above / below * b[i]);
        return {above / below, Estimate::of(rest).error / below};
    }

    void expect_equal(const std::vector<Values>& a, const std::vector<Values>& b,
                      const char* other) const {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const Estimate r = ratio(a[i], b[i]);
            EXPECT_LT(std::abs(r.mean - 1) + 2.58 * r.error, GetParam().band)
                << "over " << other << ", block " << i << ": " << r.mean << " +- " << r.error;
        }
    }
};

TEST_P(SamplerEquivalence, adaptive_random_uniform) {
    const Scene world = scene();
    const auto adaptive = blocks(world, PhotonSampler::adaptive);
    expect_equal(adaptive, blocks(world, PhotonSampler::random), "random");
    expect_equal(adaptive, blocks(world, PhotonSampler::uniform), "uniform");
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SamplerEquivalence,
    testing::Values(Case{"two-islands", 2, 0.005, 100}, Case{"cornell", 2, 0.005, 40},
                    Case{"cognac-0", 2, 0.005, 36}, Case{"cognac-1", 1, 0.005, 100},
                    Case{"cognac-2", 1, 0.005, 240}, Case{"cognac-3", 1, 0.005, 480},
                    Case{"window-room", 1, 0.01, 400}),
    [](const auto& info) {
        std::string name = info.param.scene;
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    });

}  // namespace
}  // namespace sunfleck::engine
