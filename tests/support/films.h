// Films of complete batches, as the default settings make them.
#pragma once

#include "render/count_pass.h"
#include "support/renders.h"

#include <cstdint>
#include <optional>

namespace sunfleck::engine::testing_support {

/// Calls see(film) after each pass.
template <class See>
Film film_of_batches(const Scene& scene, const RenderSettings& settings, std::uint32_t batches,
                     const See& see) {
    const PixelWindow window = window_of(scene.film());
    FilmKey key;
    key.width = window.width();
    key.height = window.height();
    key.small_passes = small_passes(settings, key.pixels());
    Film film(key);
    std::optional<Epoch> epoch;
    for (std::uint32_t p = 0; p < batches * kBatchPasses; ++p) {
        if (!epoch || epoch->number != epoch_of(p)) epoch = learn_epoch(scene, settings, p);
        add_pass(film, p, render_pass(scene, settings, p, *epoch));
        see(film);
    }
    return film;
}

inline Film film_of_batches(const Scene& scene, const RenderSettings& settings,
                            std::uint32_t batches) {
    return film_of_batches(scene, settings, batches, [](const Film&) {});
}

}  // namespace sunfleck::engine::testing_support
