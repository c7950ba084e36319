// Films of complete batches, as the default settings make them.
#pragma once

#include "render/count_pass.h"
#include "support/renders.h"

#include <array>
#include <cstdint>
#include <optional>

namespace sunfleck::engine::testing_support {

/// Of each epoch's passes, how often they count in place of once, and how many times as many photon
/// paths they have: 512 passes are of three epochs.
using EpochWeights = std::array<std::uint32_t, 3>;

/// @param settings  with a number of photon paths.
inline Film film_of_batches(const Scene& scene, const RenderSettings& settings,
                            std::uint32_t batches, const EpochWeights& weights = {1, 1, 1}) {
    const PixelWindow window = window_of(scene.film());
    FilmKey key;
    key.width = window.width();
    key.height = window.height();
    Film film(key);
    std::optional<Epoch> epoch;
    RenderSettings of_epoch = settings;
    for (std::uint32_t p = 0; p < batches * kBatchPasses; ++p) {
        const std::uint32_t weight = weights.at(epoch_of(p));
        if (!epoch || epoch->number != epoch_of(p)) {
            of_epoch.photon.paths_per_pass = weight * settings.photon.paths_per_pass.value();
            epoch = learn_epoch(scene, of_epoch, p);
            epoch->weight = weight;
        }
        add_pass(film, p, render_pass(scene, of_epoch, p, *epoch));
    }
    return film;
}

}  // namespace sunfleck::engine::testing_support
