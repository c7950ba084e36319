// One picture, to the last bit: with any number of threads, and however passes are cut and ordered.
#include "core/parallel.h"
#include "render/pass_maker.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr int kSize = 20;              // two blocks of the camera pass
constexpr std::uint32_t kPasses = 18;  // a batch and a bit

std::string scene_text(const std::string& object_material) {
    return view("0 -4 2  0 0 0.5  0 0 1", 40, kSize) +
           "LightSource \"distant\" \"point3 from\" [1 1 3] \"point3 to\" [0 0 0]\n" +
           diffuse("0.7 0.5 0.2") + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0") +
           "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [3 4 5]\n" +
           quad("-1 1 3  1 1 3  1 -1 3  -1 -1 3") + "AttributeEnd\nMaterial " + object_material +
           "\nTranslate 0 0 0.8\nShape \"sphere\" \"float radius\" 0.7\n";
}

RenderSettings settings_of(Integrator integrator) {
    RenderSettings settings;
    settings.integrator = integrator;
    settings.photon.paths_per_pass = 3'000;
    settings.aovs.fill(true);
    settings.seed = 17;
    return settings;
}

/// The film of these passes, in this order.
Film film_of(const Scene& scene, const std::vector<std::uint32_t>& passes,
             const RenderSettings& settings) {
    const RenderJob job{scene, settings, {}, 0};
    RenderState state{Film(key_of(job)), {}, 0, 0, 1, {}};
    PassMaker maker(job, state);
    for (const std::uint32_t p : passes) maker.make(p, state.film);
    return std::move(state.film);
}

struct Case {
    const char* name;
    const char* material;
    IndirectLight indirect = IndirectLight::photons;
    bool starts_small = false;
};

class SameBytes : public ::testing::TestWithParam<Case> {};

TEST_P(SameBytes, with_any_number_of_threads_and_in_any_order) {
    const Scene scene = scene_of(scene_text(GetParam().material));
    RenderSettings settings = settings_of(Integrator::sppm);
    settings.transport.indirect = GetParam().indirect;
    if (GetParam().starts_small) settings.large_picture = 0;
    std::vector<std::uint32_t> order(kPasses);
    for (std::uint32_t p = 0; p < kPasses; ++p) order[p] = p;
    const Film whole = [&] {
        const ThreadLimit limit(1);
        return film_of(scene, order, settings);
    }();
    EXPECT_GT(whole.statistic("deposits"), 0);
    std::reverse(order.begin(), order.end());
    std::swap(order[2], order[11]);
    for (const std::size_t threads : {2U, 3U, 8U}) {
        const ThreadLimit limit(threads);
        EXPECT_TRUE(film_of(scene, order, settings).sums() == whole.sums()) << threads;
        std::rotate(order.begin(), order.begin() + 5, order.end());
    }
    // In three pieces, each film by itself, merged out of order.
    Film merged = film_of(scene, {order.begin() + 9, order.end()}, settings);
    merge(merged, film_of(scene, {order.begin(), order.begin() + 4}, settings));
    merge(merged, film_of(scene, {order.begin() + 4, order.begin() + 9}, settings));
    EXPECT_TRUE(merged.sums() == whole.sums());
}

/// In place of a material: a ball of fire.
constexpr const char* kFire =
    "\"interface\"\nMakeNamedMedium \"fire\" \"string type\" \"uniformgrid\" \"integer nx\" 2 "
    "\"float density\" [1 3] \"float temperature\" [2000 3000] \"float Lescale\" 9 "
    "\"point3 p0\" [-1 -1 -1]\nMediumInterface \"fire\" \"\"\n";

INSTANTIATE_TEST_SUITE_P(
    Scenes, SameBytes,
    ::testing::Values(Case{"diffuse", "\"diffuse\""}, Case{"fire", kFire, IndirectLight::sampled},
                      Case{"glass", "\"dielectric\" \"spectrum eta\" \"glass-F11\""},
                      Case{"glossy", "\"conductor\" \"float roughness\" 0.2"},
                      Case{"glass_and_small_passes",
                           "\"dielectric\" \"spectrum eta\" \"glass-F11\"", IndirectLight::photons,
                           true},
                      Case{"glass_and_long_camera_paths",
                           "\"dielectric\" \"spectrum eta\" \"glass-F11\"",
                           IndirectLight::sampled}),
    [](const auto& row) { return std::string(row.param.name); });

class ReferenceSameBytes : public ::testing::TestWithParam<Integrator> {};

TEST_P(ReferenceSameBytes, with_any_number_of_threads_and_merged) {
    const Scene scene = scene_of(scene_text("\"dielectric\" \"spectrum eta\" \"glass-F11\""));
    const auto film = [&](std::size_t threads, const std::vector<std::uint32_t>& passes) {
        const ThreadLimit limit(threads);
        return film_of(scene, passes, settings_of(GetParam()));
    };
    const Film whole = film(1, {0, 1, 2, 3});
    EXPECT_FALSE(film(1, {0, 1, 2, 4}).sums() == whole.sums());
    EXPECT_TRUE(film(2, {2, 0, 3, 1}).sums() == whole.sums());
    Film merged = film(3, {2, 3});
    merge(merged, film(2, {0, 1}));
    EXPECT_TRUE(merged.sums() == whole.sums());
}

INSTANTIATE_TEST_SUITE_P(Of, ReferenceSameBytes,
                         ::testing::Values(Integrator::path, Integrator::light, Integrator::bdpt,
                                           Integrator::mlt),
                         [](const auto& info) { return std::string(name_of(info.param)); });

}  // namespace
}  // namespace sunfleck::engine
