// What the default settings learn, who brings indirect light and camera paths shared out, leaves
// the expectation alone: block by block, renders of 48 passes of all defaults against `random` with
// even camera paths. Radii are a function of the number of a pass: so the expectation is the same.
// Of the ratio of brightness the 99% interval lies within 1% of one.
//
// No noise is shared, and renders of the reference are cheap and noisy: of each there are several
// to one of the default, of fewer photons where camera paths make the noise (some 10 minutes of one
// core for each scene, 2 for the Cornell box).
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

struct Case {
    std::string scene;
    int renders;
    int references;  // to one of these
    std::uint32_t reference_paths;
};

/// Of a test's name.
std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.scene;
}

class DefaultsEquivalence : public testing::TestWithParam<Case> {
protected:
    static constexpr std::uint32_t kEnd = 48;  // of the passes
    static constexpr int kBlock = 8;
    static constexpr int kBlocks = 2;  // each way

    /// Brightness of one block, by render.
    using Values = std::vector<double>;

    /// Brightness of the blocks, summed over passes.
    struct Sums {
        std::vector<double> light = std::vector<double>(kBlocks * kBlocks, 0);

        void add(const PassImage& image) {
            constexpr std::size_t kWidth = kBlock * kBlocks;
            for (std::size_t i = 0; i < image.pixels(); ++i) {
                const std::size_t block = i / kWidth / kBlock * kBlocks + i % kWidth / kBlock;
                light[block] += luminance(pixel_value(image, i)) / (kBlock * kBlock);
            }
        }
        void add_to(std::vector<Values>& blocks) const {
            for (std::size_t b = 0; b < blocks.size(); ++b) blocks[b].push_back(light[b] / kEnd);
        }
    };

    /// Passes 0 .. kEnd - 1. @param seen  their epochs.
    static Sums passes(const Scene& scene, const RenderSettings& settings,
                       std::vector<Epoch>& seen) {
        Sums sums;
        for (std::uint32_t p = 0; p < kEnd; ++p) {
            const std::uint32_t number = epoch_of(p);
            if (seen.size() == number) seen.push_back(learn_epoch(scene, settings, p));
            const PassResult pass = render_pass(scene, settings, p, seen[number]);
            sums.add(pass.image);
        }
        return sums;
    }

    static RenderSettings reference_settings() {
        RenderSettings settings;
        settings.photon.sampler = PhotonSampler::random;
        settings.photon.adaptive_pixels = false;
        settings.photon.paths_per_pass = GetParam().reference_paths;
        return settings;
    }

    void render_both() {
        const Scene scene = procedural(GetParam().scene, kBlock * kBlocks);
        RenderSettings defaults;
        RenderSettings reference = reference_settings();
        for (int i = 0; i < GetParam().renders; ++i) {
            defaults.seed = static_cast<std::uint64_t>(i);
            std::vector<Epoch> epochs;
            passes(scene, defaults, epochs).add_to(defaults_);
            is_at_work_ |= !epochs[1].log2_samples.empty() ||
                           epochs[1].transport.indirect == IndirectLight::sampled;
            for (int j = 0; j < GetParam().references; ++j) {
                reference.seed = static_cast<std::uint64_t>(1000 + i * GetParam().references + j);
                std::vector<Epoch> plain;
                passes(scene, reference, plain).add_to(reference_);
            }
        }
    }

    std::vector<Values> defaults_ = std::vector<Values>(kBlocks * kBlocks);
    std::vector<Values> reference_ = std::vector<Values>(kBlocks * kBlocks);
    bool is_at_work_ = false;  // what the reference does not have
};

TEST_P(DefaultsEquivalence, has_the_expectation_of_plain_passes) {
    render_both();
    EXPECT_TRUE(is_at_work_);
    for (std::size_t b = 0; b < defaults_.size(); ++b) {
        const Estimate defaults = Estimate::of(defaults_[b]);
        const Estimate reference = Estimate::of(reference_[b]);
        const double error =
            std::hypot(defaults.error / defaults.mean, reference.error / reference.mean);
        const std::string text = std::to_string(defaults.mean / reference.mean) + " +- " +
                                 std::to_string(error) + ", of the default alone " +
                                 std::to_string(defaults.error / defaults.mean);
        RecordProperty("block_" + std::to_string(b), text);
        EXPECT_LT(worst_ratio(defaults, reference), 0.01) << "block " << b << ": " << text;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, DefaultsEquivalence,
                         testing::Values(Case{"cornell", 16, 10, 20'000},
                                         Case{"statue-near", 100, 12, 2'000},
                                         Case{"useless-light", 24, 8, 200'000}),
                         [](const auto& info) {
                             std::string name = info.param.scene;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace sunfleck::engine
