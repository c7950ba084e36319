// Passes of noise with a known spread, for the tests of the film.
#pragma once

#include "core/random.h"
#include "film/film.h"
#include "film/luminance.h"
#include "film/pass_weight.h"
#include "math/wavelengths.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace sunfleck::engine::testing_support {

/// With discs: photons bring a part of the light. With AOVs of two lights, and small passes.
inline FilmKey small_key(int width = 19, int height = 10) {
    FilmKey key{width, height, {}, 7, 0xABCDEF, "alpha=0.667\nphotons_per_pass=1000\n"};
    key.alpha = 2.0 / 3;
    key.small_passes = kSmallPasses;
    key.aovs[static_cast<std::size_t>(Aov::caustic)] = true;
    key.aovs[static_cast<std::size_t>(Aov::depth)] = true;
    key.light_groups = {"sun", "lamp"};
    return key;
}

/// A pass of skewed noise, some of it negative, of many magnitudes: a function of (seed, number).
inline PassImage noise_pass(const FilmKey& key, std::uint32_t number) {
    std::optional<BlockGrid> photon_cells;
    if (key.has_discs()) photon_cells = photon_cells_of(key);
    PassImage image(key.pixels(), key.aovs, photon_cells, key.light_groups.size());
    for (std::size_t i = 0; i < key.pixels(); ++i) {
        RandomStream random(key.seed, Purpose::test, number, static_cast<std::uint32_t>(i));
        const float size = std::exp(20 * random.next_float() - 12);
        const Vec3 rgb(size, random.next_float() * size, -0.01F * size);
        image.add_light(i, rgb, random.next_float() < 0.5F ? Aov::caustic : Aov::indirect);
        image.add_camera_light(i, Vec3(random.next_float(), 2 * size, 1), Aov::direct);
        image.add_feature(i, Vec3(3 + random.next_float(), 0, 0), Aov::depth);
        for (std::size_t aov = 0; aov < image.light_groups(); ++aov)
            image.add_to_light_group(i, rgb * random.next_float(), static_cast<std::uint8_t>(aov));
    }
    return image;
}

inline Film film_of(const FilmKey& key, const std::vector<std::uint32_t>& passes) {
    Film film(key);
    for (const std::uint32_t pass : passes) {
        film.add_pass(pass, noise_pass(key, pass));
        film.count("rays", 100 + pass);
        film.sum("visible_fraction", 0.1 / (pass + 1));
    }
    return film;
}

/// A film whose pass values are given by value(pass, pixel), grey.
template <class Value>
Film film_by_pass(const FilmKey& key, std::uint32_t passes, const Value& value) {
    Film film(key);
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
        PassImage image(key.pixels(), key.aovs);
        for (std::size_t i = 0; i < key.pixels(); ++i)
            image.add_light(i, Vec3(value(pass, i)), Aov::direct);
        film.add_pass(pass, image);
    }
    return film;
}

template <class Value>
Film film_by_pass(int width, int height, std::uint32_t passes, const Value& value) {
    return film_by_pass(FilmKey{width, height, {}, 1, 0, ""}, passes, value);
}

/// The same by value(batch, pixel), of whole batches.
template <class Value>
Film film_by_batch(int width, int height, std::uint32_t passes, const Value& value) {
    return film_by_pass(width, height, passes, [&](std::uint32_t pass, std::size_t pixel) {
        return value(pass / kBatchPasses, pixel);
    });
}

/// Ranges are disjoint.
inline PassSet set_of(const std::vector<PassRange>& ranges) {
    PassSet passes;
    for (const PassRange& range : ranges) passes.insert(range);
    return passes;
}

inline std::vector<std::uint32_t> numbers(std::uint32_t begin, std::uint32_t end) {
    std::vector<std::uint32_t> all(end - begin);
    std::iota(all.begin(), all.end(), begin);
    return all;
}

inline void shuffle(std::vector<std::uint32_t>& values, std::uint32_t which) {
    RandomStream random(99, Purpose::test, which, 0);
    for (std::size_t i = values.size(); i > 1; --i)
        std::swap(values[i - 1],
                  values[static_cast<std::size_t>(random.next() * static_cast<double>(i))]);
}

}  // namespace sunfleck::engine::testing_support
