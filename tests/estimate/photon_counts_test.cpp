// Photons that stand for several alike: the light of all, and counts of photons by pixel.
#include "estimate/photon_counts.h"

#include "core/parallel.h"
#include "estimate/deposit.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kPixels = 40;
constexpr std::uint32_t kPaths = 700;
constexpr int kMaxDepth = 6;

class PhotonCopies : public ::testing::Test {
protected:
    PhotonCopies() {
        for (std::uint32_t i = 0; i < 200; ++i) {
            VisiblePoint p;
            p.disc.position = Vec3(random_.next_float(), random_.next_float(), 0);
            p.disc.radius = 0.02F + 0.1F * random_.next_float();
            p.disc.normal = p.shading_normal = p.wo = Vec3(0, 0, 1);
            p.disc.kinds = static_cast<std::uint8_t>(1 + i % 15);
            p.throughput = SampledSpectrum(random_.next_float());
            p.pixel = static_cast<std::uint32_t>(i % kPixels);
            p.bsdf = kLambertian;
            points_.push_back(p);
        }
        for (std::uint32_t i = 0; i < 3000; ++i) {
            Photon photon;
            photon.position = Vec3(1.2F * random_.next_float() - 0.1F, random_.next_float(), 0);
            photon.normal = photon.w = Vec3(0, 0, 1);
            photon.kind = static_cast<PhotonKind>(1U << (i % 4));
            photon.flux = SampledSpectrum(random_.next_float());
            photons_.push_back(photon);
        }
    }

    static std::uint32_t copies_of(std::size_t i) { return 1 + static_cast<std::uint32_t>(i % 9); }
    std::vector<PhotonChunk> together() const {
        std::vector<PhotonChunk> chunks(2);
        for (std::uint32_t i = 0; i < photons_.size(); ++i)
            chunks[i % 2].add_copies(photons_[i], i, copies_of(i));
        return chunks;
    }
    std::vector<PhotonChunk> one_by_one() const {
        std::vector<PhotonChunk> chunks(1);
        for (std::uint32_t i = 0; i < photons_.size(); ++i)
            for (std::uint32_t k = 0; k < copies_of(i); ++k) chunks[0].add(photons_[i], i);
        return chunks;
    }

    struct Result {
        PassImage image = PassImage(kPixels, all_aovs());
        PhotonCounts taken = PhotonCounts(kPixels);
        Statistics counts;
    };
    static AovSet all_aovs() {
        AovSet aovs;
        aovs.fill(true);
        return aovs;
    }
    Result deposited(std::vector<PhotonChunk> chunks) const {
        Result result;
        const VisiblePointIndex index({points_}, kMaxDepth);
        result.counts = Depositor(pass_, index, result.image, kPaths, &result.taken)(chunks);
        return result;
    }

    Scene scene_{SceneDescription{}};
    PassScene pass_{scene_, {4, 0}};
    RandomStream random_{4, Purpose::test, 0, 0};
    std::vector<VisiblePoint> points_;
    std::vector<Photon> photons_;
};

TEST_F(PhotonCopies, bring_the_light_of_as_many_photons) {
    const Result result = deposited(together());
    const Result expected = deposited(one_by_one());
    for (const Aov aov : {Aov::total, Aov::direct, Aov::caustic, Aov::indirect})
        for (std::size_t i = 0; i < kPixels; ++i) {
            const double value = expected.image.value(aov, i, 1).to_double();
            EXPECT_GT(value, 0);
            ASSERT_NEAR(result.image.value(aov, i, 1).to_double(), value, 1e-5 * value);
        }
    for (std::size_t i = 0; i < kPixels; ++i) EXPECT_EQ(result.taken[i], expected.taken[i]) << i;
}

TEST_F(PhotonCopies, are_counted_by_pixel) {
    const Result result = deposited(together());
    std::vector<std::uint64_t> taken(kPixels, 0);
    std::uint64_t deposits = 0;
    std::uint64_t stored = 0;
    for (std::size_t i = 0; i < photons_.size(); ++i) {
        const std::uint64_t before = deposits;
        for (const VisiblePoint& point : points_) {
            if (!accepts(point.disc, photons_[i], kMaxDepth)) continue;
            taken[point.pixel] += copies_of(i);
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

/// Several deposits, of which each goes on counting.
TEST_F(PhotonCopies, of_all_deposits_add_up_on_any_number_of_threads) {
    const VisiblePointIndex index({points_}, kMaxDepth);
    const auto counted = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        PassImage image(kPixels, all_aovs());
        PhotonCounts taken(kPixels);
        const Depositor deposit(pass_, index, image, kPaths, &taken);
        auto chunks = together();
        deposit(chunks);
        deposit(chunks);
        return std::vector<std::uint64_t>(taken.begin(), taken.end());
    };
    const std::vector<std::uint64_t> three = counted(3);
    EXPECT_EQ(counted(1), three);
    const Result once = deposited(together());
    for (std::size_t i = 0; i < kPixels; ++i) EXPECT_EQ(three[i], 2 * once.taken[i]) << i;
}

}  // namespace
}  // namespace sunfleck::engine
