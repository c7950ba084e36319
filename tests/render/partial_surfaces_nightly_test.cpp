// Surfaces that are there in part, by all estimators: the table of equivalence with path tracing.
//
// The 99% interval of the ratio of brightness lies within 1 +- 0.5%, and that of each block within
// 1 +- 2%. All must lie inside, so their number needs no correction: to pass wrongly, the block
// that is farthest off must. Renders go on until that is known, or until their number shows that it
// is not so. Each row is a scene, an estimator; its figures are printed.
#include "partial_surfaces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr std::size_t kBlock = 20;
constexpr std::size_t kAcross = partial_surfaces::kSize / kBlock;
constexpr double kMeanBand = 0.005;
constexpr double kBlockBand = 0.02;

/// Brightness of the picture and of its blocks, by batch of one render.
class Brightness {
public:
    Brightness(const Scene& scene, RenderSettings settings)
        : scene_(scene), settings_(std::move(settings)) {}

    const std::vector<double>& mean() const { return mean_; }
    const std::vector<double>& block(std::size_t b) const { return blocks_.at(b); }
    /// Of the mean, relative.
    double error() const {
        const Estimate estimate = Estimate::of(mean_);
        return estimate.error / estimate.mean;
    }

    /// Goes on by some batches of passes.
    void add(int batches) {
        for (int i = 0; i < batches; ++i) {
            std::array<double, kAcross * kAcross> light{};
            for (std::uint32_t p = 0; p < kBatchPasses; ++p) add_pass(light);
            double sum = 0;
            for (std::size_t b = 0; b < light.size(); ++b) {
                blocks_[b].push_back(light[b]);
                sum += light[b] / light.size();
            }
            mean_.push_back(sum);
        }
    }

private:
    void add_pass(std::array<double, kAcross * kAcross>& light) {
        if (!epoch_ || epoch_->number != epoch_of(next_))
            epoch_ = learn_epoch(scene_, settings_, next_);
        const PassResult pass = render_pass(scene_, settings_, next_++, *epoch_);
        constexpr std::size_t kWidth = partial_surfaces::kSize;
        for (std::size_t i = 0; i < pass.image.pixels(); ++i)
            light[i / kWidth / kBlock * kAcross + i % kWidth / kBlock] +=
                luminance(pixel_value(pass.image, i)) / (kBlock * kBlock * kBatchPasses);
    }

    const Scene& scene_;
    RenderSettings settings_;
    std::optional<Epoch> epoch_;
    std::uint32_t next_ = 0;  // pass
    std::vector<double> mean_;
    std::array<std::vector<double>, kAcross * kAcross> blocks_;
};

struct Verdict {
    double ratio = 0;
    double error = 0;        // standard error of the ratio
    double worst_mean = 0;   // end of the interval that is farther from one
    double worst_block = 0;  // the same, of all blocks
    bool holds() const { return worst_mean < kMeanBand && worst_block < kBlockBand; }
    /// Is it known that the band is left?
    bool fails() const { return std::abs(ratio - 1) - 4 * error > kMeanBand; }
};

Verdict compare(const Brightness& tried, const Brightness& truth) {
    const Estimate a = Estimate::of(tried.mean());
    const Estimate b = Estimate::of(truth.mean());
    Verdict verdict;
    verdict.ratio = a.mean / b.mean;
    verdict.error = std::hypot(a.error / a.mean, b.error / b.mean);
    verdict.worst_mean = worst_ratio(a, b);
    for (std::size_t i = 0; i < kAcross * kAcross; ++i)
        verdict.worst_block =
            std::max(verdict.worst_block,
                     worst_ratio(Estimate::of(tried.block(i)), Estimate::of(truth.block(i))));
    return verdict;
}

struct Estimator {
    const char* name;
    RenderSettings settings;
    bool sees_mirrors = true;
};

std::vector<Estimator> estimators() {
    std::vector<Estimator> all;
    RenderSettings usual;
    usual.camera.radius_pixels = 1;
    usual.photon.paths_per_pass = 10'000;
    usual.photon.adaptive_pixels = false;
    const auto add = [&](const char* name, const auto& change) {
        all.push_back({name, usual});
        change(all.back().settings);
    };
    add("default", [](RenderSettings&) {});
    add("uniform", [](RenderSettings& s) { s.photon.sampler = PhotonSampler::uniform; });
    add("random", [](RenderSettings& s) { s.photon.sampler = PhotonSampler::random; });
    add("photons", [](RenderSettings& s) { s.transport.direct = DirectLight::photons; });
    add("bdpt", [](RenderSettings& s) { s.integrator = Integrator::bdpt; });
    add("light", [](RenderSettings& s) { s.integrator = Integrator::light; });
    all.back().sees_mirrors = false;
    return all;
}

class PartialSurfaces : public testing::TestWithParam<PartialScene> {};

TEST_P(PartialSurfaces, are_as_bright_by_all_estimators) {
    constexpr int kAtOnce = 5;
    constexpr int kPathsAtOnce = 20;  // a batch of path tracing is cheap
    constexpr std::size_t kMost = 10'000;
    const Scene scene = scene_of(GetParam().text);
    RenderSettings path;
    path.integrator = Integrator::path;
    Brightness truth(scene, path);
    truth.add(10 * kPathsAtOnce);
    for (Estimator& estimator : estimators()) {
        if (GetParam().has_mirror && !estimator.sees_mirrors) continue;
        Brightness tried(scene, estimator.settings);
        tried.add(2 * kAtOnce);
        Verdict verdict = compare(tried, truth);
        while (!verdict.holds() && !verdict.fails()) {
            const bool is_truth_worse = truth.error() > tried.error();
            Brightness& worse = is_truth_worse ? truth : tried;
            if (worse.mean().size() > kMost) break;
            worse.add(is_truth_worse ? kPathsAtOnce : kAtOnce);
            verdict = compare(tried, truth);
        }
        const std::string row =
            fmt::format("{:30} {:8} {:4} {:4} {:.4f} +- {:.4f}  {:.4f} {:.4f}", GetParam().name,
                        estimator.name, tried.mean().size(), truth.mean().size(), verdict.ratio,
                        verdict.error, verdict.worst_mean, verdict.worst_block);
        fmt::print("{}\n", row);
        std::fflush(stdout);
        EXPECT_TRUE(verdict.holds()) << row;
    }
}

INSTANTIATE_TEST_SUITE_P(Table, PartialSurfaces, testing::ValuesIn(partial_scenes()),
                         [](const auto& row) {
                             std::string name = row.param.name;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

}  // namespace
}  // namespace sunfleck::engine
