// The scene at the wavelengths of one pass: every curve evaluated once.
#include "scene/pass_scene.h"

#include "core/parallel.h"

namespace sunfleck {

PassScene::PassScene(const Scene& of, PassId pass)
    : scene(of),
      wavelengths(Wavelengths::of_pass(pass)),
      emission(of.lights().size()),
      white(SpectralCurve::d65().at(wavelengths)) {
    bsdfs.reserve(of.materials().size());
    for (const Material& material : of.materials())
        bsdfs.push_back(sunfleck::bsdf_of(material, wavelengths));
    parallel_blocks(emission.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            emission[i] = curve(of.lights()[i]).at(wavelengths);
    });
}

}  // namespace sunfleck
