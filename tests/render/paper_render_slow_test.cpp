// The paper's own algorithm on whole scenes: the same bytes on any number of threads, the light of
// other samplers within its known bias, the acceptance that it aims at.
#include "core/parallel.h"
#include "film/bias.h"
#include "film/film_file.h"
#include "image/temporary_folder.h"
#include "photon_samplers/samplers.h"
#include "render/progressive.h"
#include "sunfleck/error.h"
#include "support/procedural.h"
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

RenderSettings paper(std::uint32_t paths) {
    RenderSettings settings;
    use_paper_mode(settings);
    settings.photon.paths_per_pass = paths;
    return settings;
}

Film film_of(const Scene& scene, const RenderSettings& settings, std::uint32_t passes) {
    StopSettings stop;
    stop.end_pass = passes;
    return render({scene, settings, stop}, {}).film;
}

TEST(Paper, same_bytes_with_any_number_of_threads) {
    const Scene scene = procedural("cognac-1", 40);
    RenderSettings settings = paper(150'000);  // several blocks of iterations
    settings.aovs.fill(true);
    std::vector<Film> films;
    for (const std::size_t threads : {1U, 2U, 3U}) {
        const ThreadLimit limit(threads);
        films.push_back(film_of(scene, settings, 3));
    }
    EXPECT_GT(image_mean(films[0]), 0);
    EXPECT_GT(films[0].statistic("accepted_paths"), 10'000);
    EXPECT_EQ(films[0].sums(), films[1].sums());
    EXPECT_EQ(films[0].sums(), films[2].sums());
    EXPECT_EQ(films[0].statistic("dropped_nonfinite") + films[0].statistic("saturated"), 0);
}

// 16 passes each. Uniform: brightness within 0.5%. The paper's: a million splats in correlated
// runs, about 0.5%, and pooled counts while the view moves; together less than 2%.
TEST(Paper, brightness_of_a_closed_box) {
    const Scene scene = procedural("cornell", 48);
    RenderSettings settings = paper(60'000);
    const Film chain = film_of(scene, settings, 16);
    settings.photon.sampler = PhotonSampler::uniform;
    const double uniform = image_mean(film_of(scene, settings, 16));
    EXPECT_NEAR(image_mean(chain) / uniform, 1, 0.02);
    EXPECT_NEAR(chain.statistic("visible_fraction") / 16, 0.65, 0.1);
    EXPECT_GT(chain.statistic("mutation_size"), 3);  // Table I: it grows
    EXPECT_EQ(chain.statistic("starved_passes"), 0);
}

// Six passes of 200,000 paths, more than 10^6 mutations.
TEST(Paper, acceptance_in_a_close_up) {
    const Scene scene = procedural("cognac-2", 64);
    const Film film = film_of(scene, paper(200'000), 6);
    EXPECT_NEAR(film.statistic("accepted_paths") / film.statistic("mutated_paths"), 0.234, 0.01);
    EXPECT_LT(film.statistic("mutation_size"), 1);
    EXPECT_GT(film.statistic("mutation_size"), MutationSize::kFloor);
}

class PaperFiles : public TemporaryFolder {};

/// A lamp high above a floor of which a part is seen: visible paths are one connected set.
Scene one_island() {
    return scene_of(view("0 -0.5 2  0 0 0  0 1 0", 25, 8) + diffuse("0.6 0.6 0.6") +
                    quad("-9 -9 0  9 -9 0  9 9 0  -9 9 0") +
                    "AttributeBegin\nAreaLightSource "
                    "\"diffuse\" \"rgb L\" [30 30 30]\n" +
                    quad("-1 1 5  1 1 5  1 -1 5  -1 -1 5") + "AttributeEnd\n");
}

// 12 passes of 50,000 paths, both with about 1% of noise.
TEST(Paper, a_plain_chain_agrees_on_one_island) {
    const Scene scene = one_island();
    RenderSettings settings = paper(50'000);
    const Film with = film_of(scene, settings, 12);
    settings.photon.paper.replica_exchange = false;
    const Film without = film_of(scene, settings, 12);
    settings.photon.sampler = PhotonSampler::uniform;
    const double uniform = image_mean(film_of(scene, settings, 12));
    EXPECT_NEAR(image_mean(with) / uniform, 1, 0.03);
    EXPECT_NEAR(image_mean(without) / uniform, 1, 0.03);
    EXPECT_LT(image_mean(with) / image_mean(without), 1.03);
    EXPECT_GT(without.statistic("mutated_paths"), 12 * 50'000 - 1000);
    EXPECT_LT(with.statistic("mutated_paths"), 12 * 50'000 * 0.99);
    EXPECT_NEAR(with.statistic("uniform_visible") / without.statistic("uniform_visible"), 1, 0.01);
}

/// A pass's image is what the estimate gained by it. When the visible fraction falls that is less
/// than nothing in some pixel; the sums never are.
TEST(Paper, images_of_passes_are_differences_of_estimates) {
    const Scene scene = one_island();
    const RenderSettings settings = paper(200);
    SamplerState state = first_state(settings.photon, settings.alpha, 64);
    std::vector<double> sums(64, 0);
    double lowest_term = 0;
    double radius = 1;
    for (std::uint32_t pass = 0; pass < 12; ++pass) {
        const PassResult result =
            render_pass(scene, settings, pass, learn_epoch(scene, settings, pass), state);
        EXPECT_LE(result.statistics[Count::visible_points], 64U) << "one a pixel";
        EXPECT_LE(result.radius_factor, radius);
        radius = result.radius_factor;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const double term = pixel_value(result.image, i).y;
            lowest_term = std::min(lowest_term, term);
            sums[i] += term;
            EXPECT_GE(sums[i], 0) << "pixel " << i << " after pass " << pass;
        }
    }
    EXPECT_LT(lowest_term, 0);
    EXPECT_LT(radius, 0.9);
}

/// Batches are no samples here: no error bars, no AOV of errors, no merging.
TEST_F(PaperFiles, films_have_no_error_bars_and_stay_alone) {
    const Scene scene = one_island();
    const Film film = film_of(scene, paper(500), 64);
    EXPECT_EQ(film.pass_count(), 64U);
    EXPECT_EQ(film.batches().count, 0);
    EXPECT_TRUE(pixel_errors(film).empty());
    EXPECT_FALSE(image_error(film));
    EXPECT_FALSE(target_error(film, {}));
    EXPECT_TRUE(pixel_biases(film).empty());
    write_film(path("a.film"), film);
    const Film read = read_film(path("a.film"));
    EXPECT_EQ(read.sums(), film.sums());
    EXPECT_TRUE(read.key().sequential);
    Film none(film.key());
    EXPECT_THROW(none.merge(film, "a.film"), Error);
}

}  // namespace
}  // namespace sunfleck::engine
