// Evaluation of the scene for a pass, and of textured materials at points.
#include "scene/pass_scene.h"

#include "core/parallel.h"
#include "math/sigmoid_table.h"
#include "math/white_balance.h"

namespace sunfleck::engine {

namespace {

Wavelengths wavelengths_of(const FilmDescription& film, PassId pass) {
    Wavelengths drawn = Wavelengths::of_pass(pass);
    if (film.white) drawn.transform_rgb(white_balance(*film.white));
    return drawn;
}

}  // namespace

PassScene::PassScene(const Scene& of, PassId pass)
    : scene(of),
      wavelengths(wavelengths_of(of.film(), pass)),
      emission(of.lights().size()),
      white(Spectrum::d65().at(wavelengths)) {
    const std::size_t materials = of.materials().size();
    bsdfs.resize(materials);
    bent_.resize(materials);
    layers_.resize(materials);
    for (std::uint32_t i = 0; i < materials; ++i) {
        const Material& material = of.materials()[i];
        if (is_textured(material)) continue;
        (is_flat(of.bump_map_of(i)) ? bsdfs : bent_)[i] = bsdf_of(material, wavelengths);
        if (!bsdfs[i]) continue;
        if (const auto* coated = std::get_if<CoatedDiffuse>(&*bsdfs[i])) {
            layers_[i] = static_cast<std::uint32_t>(materials) + kept_.add(coated->base());
            kept_.add(coated->top());
        }
    }
    may_gather_.resize(materials);
    for (std::uint32_t i = 0; i < materials; ++i) may_gather_[i] = find_whether_gathers(i) ? 1 : 0;
    for (const Medium& medium : of.media().all) media.push_back(sampled(medium, wavelengths));
    phases_ = static_cast<std::uint32_t>(materials) + kept_.add(media.front().phase);
    for (std::size_t i = 1; i < media.size(); ++i) kept_.add(media[i].phase);
    light_of_medium_.assign(media.size(), kNone);
    for (std::uint32_t i = 0; i < emission.size(); ++i)
        if (const auto* light = std::get_if<MediumLight>(&of.lights()[i]))
            light_of_medium_[light->medium] = i;
    parallel_blocks(emission.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            emission[i] = curve(of.lights()[i]).at(wavelengths);
    });
}

bool PassScene::find_whether_gathers(std::uint32_t material) const {
    const Material& here = scene.materials()[material];
    if (const auto* mix = std::get_if<MixMaterial>(&here))
        return find_whether_gathers(mix->components[0]) || find_whether_gathers(mix->components[1]);
    for (const auto* constant : {&bsdfs[material], &bent_[material]})
        if (*constant) return scattering(**constant) != Scattering::specular;
    return sunfleck::engine::may_gather(here);
}

std::optional<SampledSpectrum> PassScene::glow_at(const MediumLight& light,
                                                  const Vec3& point) const {
    const SampledMedium& medium = media[light.medium];
    const float drawn = light.density->at(point);
    if (!(drawn > 0) || scene.medium_around(point) != light.medium) return {};
    return sunfleck::engine::glow_at(medium, wavelengths, point) * medium.absorption *
           (density_at(medium, point) / drawn);
}

MediumNumber PassScene::start_medium(std::size_t light, const Emission& start,
                                     SampledSpectrum& flux) const {
    if (!scene.has_media()) return 0;
    const MediumNumber medium =
        scene.media().at_lights[light].towards(start.normal, Vec3(start.direction));
    if (comes_from_afar(scene.lights()[light]))
        flux *= transmittance(medium, {Vec3(start.origin), -Vec3(start.direction)});
    return medium;
}

SampledSpectrum PassScene::seen_from(const Hit& hit, const Vec3& direction, float distance,
                                     MediumNumber medium) const {
    Ray ray = shadow_ray(hit, direction, distance);
    if (!scene.has_media()) return SampledSpectrum(scene.is_free(ray) ? 1 : 0);
    SampledSpectrum left(1);
    const float past_end = distance - ray.length;
    while (const auto met = scene.geometry().intersect(ray)) {
        if (!scene.is_null_interface(*met)) return SampledSpectrum(0);
        left *= transmittance(medium, {ray.origin, direction, met->distance});
        medium = scene.medium_beyond(*met, direction, medium);
        const float rest = ray.length - met->distance;
        if (!(rest > 0)) return left;
        ray = ray_from(*met, direction);
        ray.length = rest;
    }
    if (distance < kInfinity) ray.length += past_end;
    return left * transmittance(medium, ray);
}

/// Greys are exact, and do not need the table.
SampledSpectrum PassScene::colour(const Vec3& rgb) const {
    if (rgb.x == rgb.y && rgb.y == rgb.z) return SampledSpectrum(rgb.x);
    return SigmoidTable::srgb().unbounded(rgb, wavelengths);
}

const Bsdf& PassScene::make_bsdf(Hit& hit, std::optional<Bsdf>& room) const {
    std::uint32_t number = scene.material_of(hit);
    while (const auto* mix = std::get_if<MixMaterial>(&scene.materials()[number]))
        number = mix->chosen(TexturePoint(hit, scene.origin()));
    if (bsdfs[number]) return *bsdfs[number];
    const BumpMap& bump_map = scene.bump_map_of(number);
    if (!is_flat(bump_map))
        perturb_shading(bump_map, scene.geometry().derivatives(hit), hit, scene.origin());
    if (bent_[number]) return *bent_[number];
    room = bsdf_of(scene.materials()[number], wavelengths, TexturePoint(hit, scene.origin()));
    return *room;
}

}  // namespace sunfleck::engine
