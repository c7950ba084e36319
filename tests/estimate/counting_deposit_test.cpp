// Deposits that count: the light of the plain ones with every photon given as often as it repeats.
#include "estimate/counting_deposit.h"

#include "core/parallel.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

constexpr std::size_t kPixels = 40;
constexpr std::uint32_t kPaths = 700;
constexpr int kMaxDepth = 6;

class CountingDeposits : public ::testing::Test {
protected:
    CountingDeposits() {
        for (std::uint32_t i = 0; i < 200; ++i) {
            VisiblePoint p;
            p.disc = {Vec3(random_.next_float(), random_.next_float(), 0),
                      0.02F + 0.1F * random_.next_float(),
                      Vec3(0, 0, 1),
                      0,
                      static_cast<std::uint8_t>(1 + i % 7),
                      false};
            p.shading_normal = Vec3(0, 0, 1);
            p.w_from = Vec3(0, 0, 1);
            p.throughput = Spectrum(random_.next_float());
            p.pixel = i % kPixels;
            p.bsdf = kLambertian;
            points_.push_back(p);
        }
        for (std::uint32_t i = 0; i < 3000; ++i) {
            const Vec3 position(1.2F * random_.next_float() - 0.1F, random_.next_float(), 0);
            const auto kind = static_cast<PhotonKind>(1U << (i % 3));
            photons_.add(
                {position, Vec3(0, 0, 1), Vec3(0, 0, 1), 0, kind, Spectrum(random_.next_float())},
                1 + i % 9);
        }
    }

    struct Result {
        PassImage image = PassImage(kPixels, all_layers());
        PhotonCounts taken = PhotonCounts(kPixels);
        Statistics counts;
    };
    static LayerSet all_layers() {
        LayerSet layers;
        layers.fill(true);
        return layers;
    }
    Result deposited() const {
        Result result;
        const VisiblePointIndex index(points_, kMaxDepth);
        result.counts = CountingDeposit{pass_, index, kPaths, result.image, result.taken}(photons_);
        return result;
    }

    Scene scene_{SceneDescription{}};
    PassScene pass_{scene_, {4, 0}};
    RandomStream random_{4, Purpose::test, 0, 0};
    std::vector<VisiblePoint> points_;
    RepeatedPhotons photons_;
};

TEST_F(CountingDeposits, bring_the_light_of_repeated_photons) {
    const Result result = deposited();
    std::vector<PhotonBatch> batches(1);
    for (std::uint32_t i = 0; i < photons_.photons.size(); ++i)
        for (std::uint32_t k = 0; k < photons_.repeats[i]; ++k)
            batches[0].add(photons_.photons[i], i);
    PassImage expected(kPixels, all_layers());
    const VisiblePointIndex index(points_, kMaxDepth);
    Depositor(pass_, index, expected, kPaths)(batches);
    for (const Layer layer : {Layer::total, Layer::direct, Layer::caustic, Layer::indirect})
        for (std::size_t i = 0; i < kPixels; ++i) {
            const double value = expected.value(layer, i, 1).to_double();
            ASSERT_NEAR(result.image.value(layer, i, 1).to_double(), value, 1e-5 * value);
        }
}

TEST_F(CountingDeposits, count_photons_by_pixel) {
    const Result result = deposited();
    std::vector<std::uint64_t> taken(kPixels, 0);
    std::uint64_t deposits = 0;
    std::uint64_t stored = 0;
    for (std::size_t i = 0; i < photons_.photons.size(); ++i) {
        const std::uint64_t before = deposits;
        for (const VisiblePoint& point : points_) {
            if (!takes(point.disc, photons_.photons[i], kMaxDepth)) continue;
            taken[point.pixel] += photons_.repeats[i];
            ++deposits;
        }
        stored += deposits > before ? 1 : 0;
    }
    EXPECT_GT(stored, 1000U);
    EXPECT_LT(stored, 3000U);
    EXPECT_EQ(result.counts[Count::deposits], deposits);
    EXPECT_EQ(result.counts[Count::photons_stored], stored);
    for (std::size_t i = 0; i < kPixels; ++i) EXPECT_EQ(result.taken[i], taken[i]) << i;
}

TEST_F(CountingDeposits, give_the_same_bytes_on_any_number_of_threads) {
    const auto by = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        return deposited();
    };
    const Result one = by(1);
    const Result three = by(3);
    EXPECT_EQ(one.counts, three.counts);
    for (std::size_t i = 0; i < kPixels; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_EQ(one.image.value(Layer::total, i, c), three.image.value(Layer::total, i, c));
}

}  // namespace
}  // namespace sunfleck
