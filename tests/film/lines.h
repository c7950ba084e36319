// Films whose light is a line over the area of the discs, and noise: for the tests of bias.
#pragma once

#include "core/random.h"
#include "film/film.h"
#include "film/luminance.h"
#include "visible_points/radius.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace sunfleck::engine::testing_support {

/// Light of a pass: by photons a + c s (grey), by camera paths `eye`; noise of even distribution.
struct Line {
    double a = 1;
    double c = 0.8;
    double eye = 0.5;
    double photon_noise = 0;  // standard deviation, of a photon cell in a pass, as discs make it
    double shared_noise = 0;  // of all pixels together, by photons
    double camera_noise = 0;
};

inline FilmKey line_key(int width, int height, std::uint64_t seed, double alpha = 2.0 / 3) {
    FilmKey key{width, height, {}, seed, 0, ""};
    key.alpha = alpha;
    return key;
}

/// @param line  called with a pixel. @param passes  in any order.
template <class LineOf>
Film line_film(const FilmKey& key, const std::vector<std::uint32_t>& passes, const LineOf& line) {
    Film film(key);
    for (const std::uint32_t pass : passes) {
        const double area = std::pow(radius_factor(pass, key.alpha), 2);
        const auto noise = [](RandomStream& stream) {
            return std::sqrt(12.0) * (stream.next() - 0.5);
        };
        RandomStream shared(key.seed, Purpose::test, pass, 0xFFFFFF);
        const double of_all = noise(shared);
        const BlockGrid cells = photon_cells_of(key);
        PassImage image(key.pixels(), key.aovs, cells);
        for (std::size_t i = 0; i < key.pixels(); ++i) {
            RandomStream own(key.seed, Purpose::test, pass, static_cast<std::uint32_t>(i));
            const auto number = static_cast<std::uint32_t>(cells.block_of(i));
            RandomStream of_cell(key.seed, Purpose::test, pass, 0x800000 + number);
            const Line l = line(i);
            const double photons =
                l.a + l.c * area + l.photon_noise * noise(of_cell) + l.shared_noise * of_all;
            const double eye = l.eye + l.camera_noise * noise(own);
            image.add_light(i, Vec3(static_cast<float>(photons)), Aov::indirect);
            image.add_camera_light(i, Vec3(static_cast<float>(eye)), Aov::direct);
        }
        film.add_pass(pass, image);
    }
    return film;
}

}  // namespace sunfleck::engine::testing_support
