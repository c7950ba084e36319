// One pair of paths a pixel.
#include "reference/bidirectional_integrator.h"

#include "core/parallel.h"
#include "reference/path_pair.h"

#include <mutex>

namespace sunfleck::engine {

void trace_bidirectional_paths(const ReferencePass& pass, PassImage& image,
                               Statistics& statistics) {
    const std::size_t pixels = pass.window.pixels();
    const Projection camera(pass.scene.scene.camera());
    const FilterSampler filter(pass.scene.scene.filter());
    const Splatter splatter(pass, image);
    const auto share = 1 / static_cast<float>(pixels);
    std::mutex guard;
    parallel_blocks(pixels, 256, [&](std::size_t begin, std::size_t end) {
        PathPair pair(pass, camera, splatter, static_cast<double>(pixels));
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            PathPair::Numbers numbers{PathNumbers(pass.id.stream(Purpose::pair_eye, pixel)),
                                      PathNumbers(pass.id.stream(Purpose::pair_light, pixel)),
                                      PathNumbers(pass.id.stream(Purpose::pair_joints, pixel))};
            const FilterSample filtered = filter.sample(numbers.eye.next_two());
            const Vec2d film = pass.window.place(pixel, filtered.offset);
            const SampledSpectrum scattered = pair.trace(film, numbers);
            const SampledSpectrum radiance =
                (scattered + pair.unscattered()) *
                (filtered.weight * pass.scene.scene.film().imaging_ratio);
            image.add_light(pixel, pass.scene.wavelengths.to_rgb(radiance), Aov::total);
            for (const FilmLight& splat : pair.splats())
                splatter.add(splat.film, splat.light * share);
        }
        const std::lock_guard lock(guard);
        statistics[Count::camera_rays] += pair.camera_rays();
        statistics[Count::photon_rays] += pair.light_rays();
    });
}

}  // namespace sunfleck::engine
