// The index finds exactly the discs that accepts() holds for, whatever their sizes and places.
#include "visible_points/visible_point_index.h"

#include "core/random.h"
#include "support/gather_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace sunfleck::engine {
namespace {

Vec3 direction(RandomStream& stream) {
    const float z = 2 * stream.next_float() - 1;
    const float phi = 2 * kPi * stream.next_float();
    const float r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

constexpr int kMaxDepth = 10;

/// Discs on wavy surfaces of very different scale, some far away, radii over four decades, and a
/// quarter of them cylinders in media. Every other one reaches farther for indirect photons.
std::vector<VisiblePoint> random_points(std::uint32_t count, std::uint32_t which) {
    RandomStream stream(3, Purpose::test, which, 0);
    std::vector<VisiblePoint> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        VisiblePoint& p = points[i];
        const float scale = std::pow(10.0F, -2 + 4 * stream.next_float());
        p.disc.position =
            Vec3(stream.next_float(), stream.next_float(), stream.next_float()) * scale;
        p.disc.radius = 0.05F * scale * (0.1F + stream.next_float());
        p.disc.normal = direction(stream);
        p.disc.indirect_radius_scale = i % 2 == 0 ? 2.5F : 1;
        p.disc.kinds = 15;
        p.disc.both_sides = stream.next_float() < 0.3F;
        if (i % 4 == 3) {
            p.disc.kinds <<= kKindsInMedia;
            p.disc.half_length = p.disc.radius * (0.2F + 5 * stream.next_float());
        }
        p.pixel = i;
    }
    return points;
}

/// Most photons near a disc, with a normal near its own; a half are indirect, a quarter deep
/// caustics.
Photon random_photon(const std::vector<VisiblePoint>& points, RandomStream& stream) {
    const Disc& near =
        points[static_cast<std::size_t>(stream.next() * static_cast<double>(points.size()))].disc;
    Photon photon;
    photon.normal = (near.normal + direction(stream) * stream.next_float()).normalized();
    if (stream.next_float() < 0.3F) photon.normal = -photon.normal;
    photon.kind = stream.next_float() < 0.5F   ? PhotonKind::indirect
                  : stream.next_float() < 0.5F ? PhotonKind::long_specular_chain
                                               : PhotonKind::direct;
    const float radius = near.radius_for(photon.kind);
    photon.position = near.position + direction(stream) * (radius * stream.next_float());
    photon.in_medium = near.is_in_medium() != (stream.next_float() < 0.1F);
    if (near.is_in_medium())
        photon.position += near.normal * (near.half_length * (3 * stream.next_float() - 1.5F));
    photon.w = photon.normal;
    return photon;
}

TEST(VisiblePointIndex, finds_what_the_gather_test_accepts) {
    std::uint64_t found = 0;
    for (const std::uint32_t count : {1U, 7U, 8U, 9U, 64U, 65U, 1000U}) {
        const auto points = random_points(count, count);
        const VisiblePointIndex index({points}, kMaxDepth);
        RandomStream stream(3, Purpose::test, count, 1);
        for (int i = 0; i < 4000; ++i) {
            const Photon photon = random_photon(points, stream);
            std::set<std::uint32_t> expected;
            for (const VisiblePoint& p : points)
                if (accepts(p.disc, photon, kMaxDepth)) expected.insert(p.pixel);
            std::set<std::uint32_t> actual;
            const bool any = testing_support::for_each_accepting(
                index, photon,
                [&](const VisiblePoint& p) { EXPECT_TRUE(actual.insert(p.pixel).second); });
            ASSERT_EQ(actual, expected);
            ASSERT_EQ(any, !expected.empty());
            ASSERT_EQ(index.any(photon), any);
            found += expected.size();
        }
    }
    EXPECT_GT(found, 10000U);  // the test would be empty otherwise
}

// Who is alone in its pixel is added without locks; whose light is the flux, without its bsdf.
TEST(VisiblePointIndex, knows_who_shares_a_pixel_and_who_is_plain) {
    auto points = random_points(100, 5);
    for (std::uint32_t i = 0; i < 100; ++i) {
        points[i].pixel = i < 90 ? i : i - 90;  // the last ten share those of the first ten
        points[i].bsdf = i % 3 == 0 ? 0 : kLambertian;
        const Vec3 normal = points[i].disc.normal;
        points[i].shading_normal = i % 2 == 0 ? -normal : normal;
        if (i % 5 == 0) points[i].shading_normal = Vec3(normal.y, normal.z, normal.x);
    }
    const VisiblePointIndex index({points}, kMaxDepth);
    for (std::size_t at = 0; at < 100; ++at) {
        const VisiblePoint& p = index.points()[at];
        EXPECT_EQ(p.shares_pixel, p.pixel < 10);
        const bool straight =
            p.shading_normal == p.disc.normal || p.shading_normal == -p.disc.normal;
        EXPECT_EQ((index.plain(at / 8) >> at % 8 & 1U) != 0, straight && p.bsdf == kLambertian);
        EXPECT_EQ(index.radius(at / 8, at % 8, PhotonKind::caustic), p.disc.radius);
        EXPECT_EQ(index.radius(at / 8, at % 8, PhotonKind::indirect),
                  p.disc.indirect_radius_scale * p.disc.radius);
        EXPECT_FLOAT_EQ(index.radius(at / 8, at % 8, PhotonKind::long_specular_chain),
                        (2 * p.disc.indirect_radius_scale - 1) * p.disc.radius);
    }
}

TEST(VisiblePointIndex, an_empty_index_accepts_nothing) {
    const VisiblePointIndex index({}, 10);
    EXPECT_FALSE(index.any(Photon{}));
}

class Accepts : public ::testing::Test {
protected:
    Accepts() {
        disc_.normal = Vec3(0, 0, 1);
        disc_.radius = 1;
        disc_.kinds = static_cast<std::uint8_t>(PhotonKind::caustic);
        photon_.normal = Vec3(0, 0, 1);
        photon_.kind = PhotonKind::caustic;
    }
    Disc disc_;
    Photon photon_;
};

TEST_F(Accepts, a_disc_of_its_radius) {
    photon_.position = Vec3(0.999F, 0, 0);
    EXPECT_TRUE(accepts(disc_, photon_, 4));
    photon_.position = Vec3(1.001F, 0, 0);
    EXPECT_FALSE(accepts(disc_, photon_, 4));
}

TEST_F(Accepts, not_a_ball) {
    photon_.position = Vec3(0, 0, 0.24F);
    EXPECT_TRUE(accepts(disc_, photon_, 4));
    photon_.position = Vec3(0, 0, 0.26F);
    EXPECT_FALSE(accepts(disc_, photon_, 4));
}

TEST_F(Accepts, nothing_from_the_wrong_side) {
    photon_.normal = Vec3(0, 0, -1);
    EXPECT_FALSE(accepts(disc_, photon_, 4));
    disc_.both_sides = true;
    EXPECT_TRUE(accepts(disc_, photon_, 4));
}

TEST_F(Accepts, nothing_from_the_wall_beside) {
    photon_.normal = Vec3(1, 0, 0);
    EXPECT_FALSE(accepts(disc_, photon_, 4));
}

TEST_F(Accepts, indirect_photons_and_deep_caustics_in_wider_discs) {
    disc_.kinds = 15;
    disc_.indirect_radius_scale = 3;
    const std::vector<std::pair<PhotonKind, float>> wanted = {
        {PhotonKind::direct, 1.0F},
        {PhotonKind::caustic, 1.0F},
        {PhotonKind::indirect, 3.0F},
        {PhotonKind::long_specular_chain, 5.0F}};
    for (const auto& [kind, reach] : wanted) {
        photon_.kind = kind;
        photon_.position = Vec3(0.999F * reach, 0, 0);
        EXPECT_TRUE(accepts(disc_, photon_, 4));
        photon_.position = Vec3(1.001F * reach, 0, 0);
        EXPECT_FALSE(accepts(disc_, photon_, 4));
        photon_.position = Vec3(0, 0, 0.249F * reach);
        EXPECT_TRUE(accepts(disc_, photon_, 4));
        photon_.position = Vec3(0, 0, 0.251F * reach);
        EXPECT_FALSE(accepts(disc_, photon_, 4));
    }
}

TEST_F(Accepts, only_its_kinds) {
    photon_.kind = PhotonKind::direct;
    EXPECT_FALSE(accepts(disc_, photon_, 4));
}

TEST_F(Accepts, no_path_beyond_the_greatest_depth) {
    disc_.bounces = 2;
    photon_.bounces = 1;  // with the scattering here: four events
    EXPECT_TRUE(accepts(disc_, photon_, 4));
    EXPECT_FALSE(accepts(disc_, photon_, 3));
}

/// On a sphere every photon within the tangential radius is taken, up to radius = 0.8 of the
/// sphere's: the flat disc alone would lose those that the curvature drops below it.
TEST_F(Accepts, curved_surfaces_lose_nothing) {
    const float angle = std::asin(0.79F);
    photon_.normal = Vec3(std::sin(angle), 0, std::cos(angle));
    photon_.position = (photon_.normal - Vec3(0, 0, 1));
    disc_.radius = 0.8F;
    EXPECT_TRUE(accepts(disc_, photon_, 4));
}

}  // namespace
}  // namespace sunfleck::engine
