// The film depends on the set of passes alone: not on order, splits or the tree of merges.
#include "film/film.h"

#include "sunfleck/error.h"
#include "synthetic.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::film_of;
using testing_support::noise_pass;
using testing_support::numbers;
using testing_support::shuffle;
using testing_support::small_key;

constexpr std::uint32_t kPasses = 51;  // three batches and three passes

const Film& whole() {
    static const Film film = film_of(small_key(), numbers(0, kPasses));
    return film;
}

TEST(Film, sums_are_exact) {
    Film film(FilmKey{1, 1, {}, 1, 1, ""});
    const float tiny = 0x1p-60F;
    for (std::uint32_t pass = 0; pass < 3; ++pass) {
        PassImage image(1, {});
        image.add_light(0, Vec3(pass == 1 ? -0x1p40F : 0x1p39F, tiny, 0.1F), Aov::direct);
        film.add_pass(pass, image);
    }
    const FixedPoints& total = film.sums().aovs[0];
    EXPECT_EQ(total[0], FixedPoint{});
    EXPECT_EQ(total[1], (FixedPoint{0, 3 * 16}));
    EXPECT_EQ(total[2].to_double(), 3 * static_cast<double>(0.1F));
}

TEST(Film, order_of_passes_leaves_no_trace) {
    for (std::uint32_t which = 0; which < 10; ++which) {
        std::vector<std::uint32_t> passes = numbers(0, kPasses);
        shuffle(passes, which);
        EXPECT_EQ(film_of(small_key(), passes).sums(), whole().sums()) << which;
    }
}

TEST(Film, a_split_at_any_pass_leaves_no_trace) {
    for (std::uint32_t split = 0; split <= kPasses; ++split) {
        Film head = film_of(small_key(), numbers(0, split));
        Film tail = film_of(small_key(), numbers(split, kPasses));
        Film backwards = tail;
        merge(backwards, head);
        merge(head, tail);
        EXPECT_EQ(head.sums(), whole().sums()) << split;
        EXPECT_EQ(backwards.sums(), whole().sums()) << split;
    }
}

TEST(Film, any_tree_of_merges_leaves_no_trace) {
    for (std::uint32_t which = 0; which < 20; ++which) {
        std::vector<std::uint32_t> passes = numbers(0, kPasses);
        shuffle(passes, which);
        std::vector<Film> parts;
        RandomStream random(5, Purpose::test, which, 1);
        for (std::size_t begin = 0; begin < passes.size();) {
            const auto left = static_cast<double>(passes.size() - begin);
            const auto size = 1 + static_cast<std::ptrdiff_t>(random.next() * left * 0.3);
            const auto first = passes.begin() + static_cast<std::ptrdiff_t>(begin);
            parts.push_back(film_of(small_key(), {first, first + size}));
            begin += static_cast<std::size_t>(size);
        }
        while (parts.size() > 1) {
            const auto count = static_cast<double>(parts.size() - 1);
            const auto i = static_cast<std::size_t>(random.next() * count);
            merge(parts[i], parts.back());
            parts.pop_back();
        }
        EXPECT_EQ(parts[0].sums(), whole().sums()) << which;
    }
}

/// They are kept until four batches are whole.
TEST(Film, early_batches_leave_no_trace) {
    for (const std::uint32_t count : {63U, 70U}) {
        std::vector<std::uint32_t> passes = numbers(0, count);
        const Film in_order = film_of(small_key(), passes);
        EXPECT_EQ(in_order.sums().early.pixel_squares.empty(), count >= 64);
        shuffle(passes, count);
        EXPECT_EQ(film_of(small_key(), passes).sums(), in_order.sums());
        Film merged = film_of(small_key(), numbers(16, count));
        merge(merged, film_of(small_key(), numbers(0, 16)));
        EXPECT_EQ(merged.sums(), in_order.sums());
    }
}

TEST(Film, ranks_that_take_every_nth_pass_leave_no_trace) {
    Film all(small_key());
    for (std::uint32_t rank = 0; rank < 5; ++rank) {
        std::vector<std::uint32_t> passes;
        for (std::uint32_t pass = rank; pass < kPasses; pass += 5) passes.push_back(pass);
        const Film part = film_of(small_key(), passes);
        EXPECT_EQ(whole_batches(part.passes()), 0U);
        merge(all, part);
    }
    EXPECT_EQ(all.sums(), whole().sums());
}

std::vector<std::uint64_t> firsts_of_groups(const Film& film) {
    std::vector<std::uint64_t> firsts;
    for (const auto& [first, group] : film.sums().open_groups) firsts.push_back(first);
    return firsts;
}

TEST(Film, only_groups_of_incomplete_batches_keep_their_own_sums) {
    EXPECT_EQ(whole_batches(whole().passes()), 3U);
    EXPECT_EQ(firsts_of_groups(whole()), (std::vector<std::uint64_t>{48, 50}));
    const Film film = film_of(small_key(), numbers(15, 33));
    EXPECT_EQ(whole_batches(film.passes()), 1U);
    EXPECT_EQ(firsts_of_groups(film), (std::vector<std::uint64_t>{12, 32}));
}

/// Two passes of batch 0 and one of batch 1, by hand: camera paths bring 5, photons 2, 4 and 8.
TEST(Film, what_photons_bring_is_summed_by_area) {
    FilmKey key{1, 1, {}, 1, 1, ""};
    key.alpha = 0.5;
    Film film(key);
    for (const std::uint32_t pass : {3U, 7U, 20U}) {
        PassImage image(1, {}, photon_cells_of(1, 1));
        image.add_light(0, Vec3(pass == 3 ? 2 : pass == 7 ? 4 : 8), Aov::caustic);
        image.add_camera_light(0, Vec3(5), Aov::direct);
        film.add_pass(pass, image);
    }
    const FilmSums& sums = film.sums();
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(sums.aovs[0][c].to_double(), 14 + 15);
        EXPECT_EQ(sums.photons.rgb[c].to_double(), 14);
        EXPECT_NEAR(sums.photons.rgb_by_area[c].to_double(),
                    (2 + 4) * area_of(key, {0, 16}) + 8 * area_of(key, {16, 32}), 1e-15);
        EXPECT_EQ(sums.open_groups.at(2).photon_blocks[c].to_double(), 2);
        EXPECT_EQ(sums.open_groups.at(6).photon_blocks[c].to_double(), 4);
        EXPECT_EQ(sums.open_groups.at(20).photon_blocks[c].to_double(), 8);
    }
}

/// Small passes of 8 and 24, others of 2: each in proportion to its weight.
TEST(Film, small_passes_count_a_quarter) {
    FilmKey key{1, 1, {}, 1, 1, ""};
    key.alpha = 0.5;
    key.small_passes = 2;
    Film film(key);
    for (std::uint32_t pass = 0; pass < 16; ++pass) {
        PassImage image(1, {}, photon_cells_of(1, 1));
        image.add_light(0, Vec3(pass == 0 ? 8 : pass == 1 ? 24 : 2), Aov::caustic);
        film.add_pass(pass, image);
    }
    EXPECT_EQ(film.weight(), 14.5);
    const FilmSums& sums = film.sums();
    EXPECT_EQ(sums.aovs[0][0].to_double(), 2 + 6 + 14 * 2);
    EXPECT_EQ(sums.photons.rgb[0].to_double(), 2 + 6 + 14 * 2);
    // The mean of the batch, squared, as often as it has passes of sixteen.
    const double mean = (2 + 6 + 14 * 2) / 14.5;
    EXPECT_NEAR(sums.pixel_squares[0].to_double(), mean * mean * 14.5 / 16, 1e-12);
    EXPECT_NEAR(sums.photons.block_squares[0].to_double(), mean * mean * 14.5 / 16, 1e-12);
    // Early batches of 1/4, 1/4, 2, 2, 2, 4, 4 passes, less the whole one.
    const double of_early = (8 * 8 + 24 * 24) / 4.0 + 14 * 2 * 2;
    EXPECT_NEAR(sums.early.pixel_squares[0].to_double(), of_early - 14.5 * mean * mean, 1e-12);
}

TEST(Film, squares_of_what_photons_bring_are_those_of_complete_batches) {
    FilmKey key{9, 1, {}, 1, 1, ""};  // blocks of eight pixels and of one
    key.alpha = 0.5;
    Film film(key);
    for (std::uint32_t pass = 0; pass < 20; ++pass) {
        PassImage image(9, {}, photon_cells_of(9, 1));
        for (std::size_t i = 0; i < 9; ++i) {
            image.add_light(i, Vec3(i < 8 ? 2 : 11), Aov::caustic);
            image.add_camera_light(i, Vec3(5), Aov::direct);
        }
        film.add_pass(pass, image);
    }
    const PhotonSums& photons = film.sums().photons;
    EXPECT_NEAR(photons.block_squares[0].to_double(), 4, 1e-12);
    EXPECT_NEAR(photons.block_squares[1].to_double(), 121, 1e-12);
    EXPECT_NEAR(photons.image_square.to_double(), 9, 1e-12);
}

TEST(Film, statistics_add_up) {
    EXPECT_EQ(whole().statistic("rays"), 100 * kPasses + kPasses * (kPasses - 1) / 2);
    double fractions = 0;
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) fractions += 0.1 / (pass + 1);
    EXPECT_NEAR(whole().statistic("visible_fraction"), fractions, 1e-14);
    EXPECT_EQ(whole().statistic("unheard of"), 0);
    Film film(FilmKey{1, 1, {}, 1, 1, ""});
    PassImage image(1, {});
    image.add_light(0, Vec3(0x1p50F, 0, 0), Aov::direct);
    image.add_light(0, Vec3(NAN, 0, 0), Aov::direct);
    film.add_pass(0, image);
    EXPECT_EQ(film.statistic("saturated"), 1);
    EXPECT_EQ(film.statistic("dropped_nonfinite"), 1);
    EXPECT_EQ(film.sums().aovs[0][0], FixedPoint::from_double(kLargestTerm));
}

TEST(Film, squares_too_large_are_cut_and_counted) {
    Film film(FilmKey{1, 1, {}, 1, 1, ""});
    for (std::uint32_t pass = 0; pass < 16; ++pass) {
        PassImage image(1, {});
        image.add_light(0, Vec3(0x1p30F), Aov::direct);
        film.add_pass(pass, image);
    }
    EXPECT_EQ(film.statistic("saturated_squares"), 3);  // of the pixel, its block, the picture
    EXPECT_EQ(film.sums().pixel_squares[0], FixedPoint::from_double(kLargestTerm));
}

std::string merge_fault(const FilmKey& key, const std::vector<std::uint32_t>& passes) {
    Film film = whole();
    try {
        film.merge(film_of(key, passes), "b.film");
    } catch (const Error& error) {
        EXPECT_EQ(film.sums(), whole().sums());  // nothing was changed
        return error.what();
    }
    return "";
}

TEST(Film, parts_of_other_renders_are_refused_by_name) {
    const auto starts = [](const std::string& text, const std::string& begin) {
        EXPECT_EQ(text.substr(0, begin.size()), begin) << text;
    };
    const std::string other = "b.film: is of another render: ";
    starts(merge_fault(small_key(), numbers(50, 60)),
           "b.film: passes 50:60 overlap those of another");
    FilmKey key = small_key(20, 10);
    starts(merge_fault(key, {90}), other + "resolution differs: 19x10 and 20x10;");
    key = small_key();
    key.seed = 8;
    starts(merge_fault(key, {90}), other + "seed differs: 7 and 8;");
    key = small_key();
    key.scene_hash = 1;
    starts(merge_fault(key, {90}), other + "scene differs;");
    key = small_key();
    key.settings = "alpha=0.667\nphotons_per_pass=2000\n";
    starts(merge_fault(key, {90}),
           other + "setting differs: photons_per_pass=1000 and photons_per_pass=2000;");
    key.settings = "alpha=0.667\n";
    starts(merge_fault(key, {90}), other + "setting differs: photons_per_pass=1000 and nothing;");
    key = small_key();
    key.alpha = 0.5;
    starts(merge_fault(key, {90}), other + "sequence of radii differs;");
    key = small_key();
    key.small_passes = 0;
    starts(merge_fault(key, {90}), other + "number of small passes differs: 4 and 0;");
    key = small_key();
    key.aovs[static_cast<std::size_t>(Aov::direct)] = true;
    starts(merge_fault(key, {90}),
           other + "set of AOVs differs: RGB caustic depth sun lamp and RGB dir");
    key = small_key();
    key.light_groups[1] = "lamps";
    starts(merge_fault(key, {90}),
           other + "set of AOVs differs: RGB caustic depth sun lamp and RGB");
    EXPECT_EQ(merge_fault(small_key(), {90}), "");
}

TEST(Film, a_pass_that_does_not_fit_is_refused) {
    Film film = film_of(small_key(), {3});
    EXPECT_THROW(film.add_pass(3, noise_pass(small_key(), 3)), Error);
    EXPECT_THROW(film.add_pass(4, noise_pass(small_key(5, 5), 4)), Error);
    EXPECT_THROW(film.add_pass(4, PassImage(small_key().pixels(), {})), Error);
    FilmKey without = small_key();
    without.alpha = 0;
    EXPECT_THROW(film.add_pass(4, noise_pass(without, 4)), Error);  // photons are not apart
    EXPECT_EQ(film.sums(), film_of(small_key(), {3}).sums());
}

/// Aovs are compared one by one: their names in a row would be the same.
TEST(Film, layers_of_other_names_are_of_another_render) {
    FilmKey key = small_key();
    key.light_groups = {"a", "b"};
    FilmKey other = key;
    other.light_groups = {"a b"};
    EXPECT_TRUE(difference(key, other).has_value());
    EXPECT_FALSE(difference(key, key).has_value());
    key.light_groups = {"direct"};
    other.light_groups = {};
    other.aovs[static_cast<std::size_t>(Aov::direct)] = true;
    key.aovs[static_cast<std::size_t>(Aov::direct)] = false;
    EXPECT_TRUE(difference(key, other).has_value());
}

}  // namespace
}  // namespace sunfleck::engine
