// Deposits against a double loop over accepts(): values, counts, marks; threads; what is not
// finite.
#include "estimate/deposit.h"

#include "core/parallel.h"
#include "estimate/photon_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kPixels = 300;
constexpr std::uint32_t kPaths = 5000;
constexpr int kMaxDepth = 6;

/// Materials 0: diffuse (needs none), 1: rough metal, 2: rough glass whose index differs by
/// wavelength.
SceneDescription materials() {
    SceneDescription scene;
    const Spectrum glass = Spectrum::table({{360, 1.7F}, {830, 1.4F}});
    scene.materials = {
        DiffuseMaterial{},
        ConductorMaterial{Spectrum::constant(0.2F), Spectrum::constant(4), {}, {0.3F, 0.5F}},
        DielectricMaterial{glass, {0.4F, 0.4F}}};
    return scene;
}

class Deposits : public ::testing::Test {
protected:
    Vec3 direction() {
        const float z = 2 * random_.next_float() - 1;
        const float phi = 2 * kPi * random_.next_float();
        const float r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>(random_.next() * count);
    }

    SampledSpectrum spectrum() {
        SampledSpectrum s;
        for (std::size_t i = 0; i < kWavelengths; ++i) s[i] = random_.next_float();
        return s;
    }

    /// Points of a bowl, in all that they can differ in; radii over two decades.
    std::vector<VisiblePoint> random_points(std::size_t count) {
        std::vector<VisiblePoint> points(count);
        for (VisiblePoint& p : points) {
            p.disc.normal = direction();
            p.disc.position = -p.disc.normal;
            p.disc.radius = 0.003F * std::pow(100.0F, random_.next_float());
            p.disc.indirect_radius_scale = 1.5F;
            p.disc.bounces = static_cast<std::uint16_t>(below(4));
            p.disc.kinds = static_cast<std::uint8_t>(1 + below(15));
            p.disc.both_sides = below(3) == 0;
            p.shading_normal = p.disc.normal;
            if (below(2) == 0) p.shading_normal = (p.disc.normal + direction() * 0.3F).normalized();
            p.tangent = direction();
            p.wo = (p.disc.normal + direction() * 0.9F).normalized();
            p.throughput = spectrum();
            p.pixel = below(kPixels);
            const std::uint32_t material = below(4);
            p.bsdf = material == 1 || material == 2 ? material : kLambertian;
            p.hero = static_cast<std::uint8_t>(below(kWavelengths));
            p.single_wavelength = below(2) == 0;
            p.after_rough = below(4) == 0;
        }
        return points;
    }

    Photon photon_near(const Disc& disc) {
        Photon photon;
        photon.normal = (disc.normal + direction() * (0.8F * random_.next_float())).normalized();
        if (below(4) == 0) photon.normal = -photon.normal;
        photon.position = disc.position + direction() * (1.2F * disc.radius * random_.next_float());
        photon.w = (photon.normal + direction() * 0.9F).normalized();
        photon.bounces = static_cast<std::uint16_t>(below(5));
        photon.kind = static_cast<PhotonKind>(1U << below(4));
        photon.flux = spectrum() * std::pow(10.0F, 4 * random_.next_float());
        return photon;
    }

    std::vector<PhotonChunk> random_chunks(const std::vector<VisiblePoint>& points) {
        std::vector<PhotonChunk> chunks(9);
        for (std::uint32_t b = 0; b < chunks.size(); ++b)
            for (std::uint32_t i = 0; i < 200 * b; ++i)
                chunks[b].add(
                    photon_near(points[below(static_cast<std::uint32_t>(points.size()))].disc),
                    i / 2);
        return chunks;
    }

    PassImage empty_image() const {
        AovSet wanted{};
        for (const Aov aov : {Aov::direct, Aov::caustic, Aov::indirect})
            wanted.at(static_cast<std::size_t>(aov)) = true;
        return {kPixels, wanted};
    }

    Scene scene_{materials()};
    PassScene pass_{scene_, {4, 0}};
    RandomStream random_{4, Purpose::test, 0, 0};
};

/// What the deposits should be, and how large the terms are: rounding is relative to those.
struct Expected {
    std::array<std::array<Vec3d, kPixels>, kAovCount> value{};
    std::array<std::array<double, kPixels>, kAovCount> size{};
    std::vector<std::vector<std::uint8_t>> taken;
    std::uint64_t deposits = 0;
    std::uint64_t stored = 0;

    Expected(const PassScene& pass, const std::vector<VisiblePoint>& points,
             const std::vector<PhotonChunk>& chunks) {
        for (const PhotonChunk& chunk : chunks) {
            taken.emplace_back();
            for (const Photon& photon : chunk.photons) {
                bool any = false;
                for (const VisiblePoint& point : points) any |= add(pass, point, photon);
                taken.back().push_back(any ? 1 : 0);
                stored += any ? 1 : 0;
            }
        }
    }

    bool add(const PassScene& pass, const VisiblePoint& point, const Photon& photon) {
        if (!accepts(point.disc, photon, kMaxDepth)) return false;
        ++deposits;
        const double cosine{point.shading_normal.dot(photon.w)};
        double corrected = std::abs(cosine / double{photon.normal.dot(photon.w)});
        const bool from_behind = cosine * double{point.shading_normal.dot(point.wo)} <= 0;
        if (point.bsdf == kLambertian && from_behind) corrected = 0;
        if (point.shading_normal == point.disc.normal) corrected = 1;
        const double radius = point.disc.radius_for(photon.kind);
        const double kernel = corrected / (kPaths * kPiDouble * radius * radius);
        SampledSpectrum value = point.throughput * photon.flux;
        if (point.bsdf != kLambertian) value *= gather_lobe(pass, point, photon.w);
        const Vec3d rgb = Vec3d(pass.wavelengths.to_rgb(value)) * kernel;
        Aov owner = Aov::caustic;
        if (photon.kind == PhotonKind::direct) owner = Aov::direct;
        if (point.after_rough || photon.kind == PhotonKind::indirect) owner = Aov::indirect;
        for (const Aov aov : {Aov::total, owner}) {
            const auto which = static_cast<std::size_t>(aov);
            value_of(which, point.pixel) += rgb;
            size.at(which).at(point.pixel) += kernel * value.sum();
        }
        return true;
    }
    Vec3d& value_of(std::size_t aov, std::size_t pixel) { return value.at(aov).at(pixel); }
};

TEST_F(Deposits, agree_with_every_point_asking_every_photon) {
    const auto points = random_points(3001);
    auto chunks = random_chunks(points);
    const Expected expected(pass_, points, chunks);
    ASSERT_GT(expected.deposits, 15'000U);
    PassImage image = empty_image();
    const VisiblePointIndex index({points}, kMaxDepth);
    const Statistics counted = Depositor(pass_, index, image, kPaths)(chunks);

    EXPECT_EQ(counted[Count::deposits], expected.deposits);
    EXPECT_EQ(counted[Count::photons_stored], expected.stored);
    EXPECT_LT(expected.stored, 7200U);  // some are not taken
    for (std::size_t b = 0; b < chunks.size(); ++b) EXPECT_EQ(chunks[b].taken, expected.taken[b]);
    for (const Aov aov : {Aov::total, Aov::direct, Aov::caustic, Aov::indirect}) {
        const auto which = static_cast<std::size_t>(aov);
        for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
            for (unsigned c = 0; c < 3; ++c)
                // A sum of n floats is off by n / 2^24 at most, here less than 40 a point; the
                // weights of to_rgb() are below four.
                ASSERT_NEAR(image.value(aov, pixel, c).to_double(),
                            expected.value.at(which).at(pixel)[static_cast<int>(c)],
                            1e-5 * expected.size.at(which).at(pixel))
                    << kAovs.at(which).name << " " << pixel << " " << c;
    }
}

TEST_F(Deposits, layers_add_up_to_the_last_bit) {
    const auto points = random_points(500);
    auto chunks = random_chunks(points);
    PassImage image = empty_image();
    const VisiblePointIndex index({points}, kMaxDepth);
    Depositor(pass_, index, image, kPaths)(chunks);
    for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
        for (unsigned c = 0; c < 3; ++c) {
            FixedPoint sum = image.value(Aov::direct, pixel, c);
            sum += image.value(Aov::caustic, pixel, c);
            sum += image.value(Aov::indirect, pixel, c);
            ASSERT_EQ(sum, image.value(Aov::total, pixel, c));
        }
}

TEST_F(Deposits, any_number_of_threads_gives_the_same_bytes) {
    const auto points = random_points(5000);
    const auto chunks = random_chunks(points);
    const VisiblePointIndex index({points}, kMaxDepth);
    const auto image_by = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        auto copy = chunks;
        PassImage image = empty_image();
        Depositor(pass_, index, image, kPaths)(copy);
        return image;
    };
    const PassImage one = image_by(1);
    const PassImage three = image_by(3);
    for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
        for (unsigned c = 0; c < 3; ++c)
            ASSERT_EQ(one.value(Aov::total, pixel, c), three.value(Aov::total, pixel, c));
}

/// A photon that is not finite, or too bright to be added, spoils nothing but itself.
TEST_F(Deposits, what_cannot_be_added_falls_alone) {
    std::vector<VisiblePoint> points(1);
    VisiblePoint& point = points[0];
    point.disc = {Vec3(0), 1, Vec3(0, 0, 1), 0, 7, false};
    point.shading_normal = point.disc.normal;
    point.throughput = SampledSpectrum(1);
    point.bsdf = kLambertian;
    Photon photon;
    photon.normal = photon.w = Vec3(0, 0, 1);
    photon.flux = SampledSpectrum(1);
    const VisiblePointIndex index({points}, kMaxDepth);
    const auto image_of = [&](std::initializer_list<float> fluxes) {
        std::vector<PhotonChunk> chunks(1);
        for (const float flux : fluxes) {
            photon.flux = SampledSpectrum(flux);
            chunks[0].add(photon, 0);
        }
        PassImage image = empty_image();
        Depositor(pass_, index, image, 1)(chunks);
        return image;
    };
    const PassImage good = image_of({1, 1});
    const PassImage bad = image_of({1, std::numeric_limits<float>::quiet_NaN(), 1});
    EXPECT_EQ(bad.dropped(), 1U);
    EXPECT_GT(good.value(Aov::total, 0, 1).to_double(), 0.1);
    EXPECT_EQ(good.dropped() + good.saturated(), 0U);
    EXPECT_NEAR(bad.value(Aov::total, 0, 1).to_double(), good.value(Aov::total, 0, 1).to_double(),
                1e-6);
    EXPECT_EQ(image_of({1, 1e20F}).saturated(), 6U);  // total and AOV, red to blue
}

TEST_F(Deposits, nothing_to_deposit_or_nowhere_to) {
    const auto points = random_points(20);
    PassImage image = empty_image();
    std::vector<PhotonChunk> none;
    const VisiblePointIndex index({points}, kMaxDepth);
    EXPECT_EQ(Depositor(pass_, index, image, kPaths)(none), Statistics());
    auto chunks = random_chunks(points);
    const VisiblePointIndex empty({}, kMaxDepth);
    EXPECT_EQ(Depositor(pass_, empty, image, kPaths)(chunks), Statistics());
}

}  // namespace
}  // namespace sunfleck::engine
