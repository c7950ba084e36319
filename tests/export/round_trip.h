// Scenes that are written and read again, and what both must have in common.
#pragma once

#include "export/pbrt_scene.h"
#include "import/pbrt/scene_text.h"
#include "scene/scene.h"

#include <map>
#include <string>

namespace sunfleck::engine {

/// The files of a scene by their names.
inline MemoryFiles files_of(const ExportedScene& exported) {
    MemoryFiles files;
    for (const ExportedFile& file : exported.files) files[file.name] = file.bytes();
    return files;
}

/// Returns the main file of a scene.
inline std::string text_of(const SceneDescription& scene) {
    return pbrt_scene(scene, "cup.pbrt").files.back().bytes();
}

/// Returns the scene as it is read from what is written of it.
inline SceneDescription again(const SceneDescription& scene) {
    const MemoryFiles files = files_of(pbrt_scene(scene, "cup.pbrt"));
    return read_pbrt_text(files.at("cup.pbrt"), "cup.pbrt", memory_access(files));
}

inline Wavelengths some_wavelengths() {
    return Wavelengths::of_pass({3, 0});
}

inline void expect_near(const SampledSpectrum& a, const SampledSpectrum& b, float tolerance,
                        const std::string& what) {
    for (std::size_t i = 0; i < kWavelengths; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance * std::max(1.0F, std::abs(a[i]))) << what << ", " << i;
}

/// The same values and the same sampled directions from several sides.
inline void expect_same(const Bsdf& a, const Bsdf& b, float tolerance = 2e-4F) {
    for (const Vec3& wo : {Vec3(0.3F, -0.2F, 0.9F), Vec3(-0.7F, 0.1F, -0.4F)})
        for (const Vec3& wi : {Vec3(0.1F, 0.5F, 0.6F), Vec3(0.6F, 0.1F, -0.7F)}) {
            const Vec3 to = wo.normalized();
            const Vec3 from = wi.normalized();
            expect_near(eval(a, to, from, Transport::radiance),
                        eval(b, to, from, Transport::radiance), tolerance, "value");
        }
    for (const float u : {0.02F, 0.3F, 0.97F}) {
        const Vec3 wo = Vec3(0.3F, -0.2F, 0.9F).normalized();
        const auto of_a = sample(a, wo, {{u, 0.4F, 0.7F}, Transport::radiance, {}});
        const auto of_b = sample(b, wo, {{u, 0.4F, 0.7F}, Transport::radiance, {}});
        ASSERT_EQ(of_a.has_value(), of_b.has_value());
        if (!of_a) continue;
        EXPECT_LT((of_a->wi - of_b->wi).length(), 1e-4F);
        expect_near(of_a->weight, of_b->weight, tolerance, "weight");
    }
}

/// The Bsdf of the material that a hit selects.
inline std::optional<Bsdf> bsdf_at(const Scene& scene, const Hit& hit) {
    std::uint32_t material = scene.material_of(hit);
    const TexturePoint point(hit, scene.origin());
    while (const auto* mix = std::get_if<MixMaterial>(&scene.materials()[material]))
        material = mix->chosen(point);
    return bsdf_of(scene.materials()[material], some_wavelengths(), point);
}

/// The same first hits along a grid of camera rays, with the same Bsdf there. @return how many.
inline int expect_same_hits(const Scene& a, const Scene& b) {
    constexpr int kSide = 16;
    int hits = 0;
    const Vec2d size(window_of(a.film()).width(), window_of(a.film()).height());
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Vec2d film((x + 0.37) / kSide * size.x, (y + 0.41) / kSide * size.y);
            const auto of_a = a.first_hit(camera_ray(a.camera(), film, {0.3, 0.6}));
            const auto of_b = b.first_hit(camera_ray(b.camera(), film, {0.3, 0.6}));
            EXPECT_EQ(of_a.has_value(), of_b.has_value()) << x << ' ' << y;
            if (!of_a || !of_b) continue;
            ++hits;
            EXPECT_EQ(of_a->shape, of_b->shape);
            EXPECT_EQ(of_a->primitive, of_b->primitive);
            EXPECT_EQ(of_a->instance, of_b->instance);
            EXPECT_LT((of_a->position - of_b->position).length(), 1e-5F);
            EXPECT_LT((of_a->normal - of_b->normal).length(), 1e-5F);
            EXPECT_LT((of_a->shading_normal - of_b->shading_normal).length(), 1e-4F);
            EXPECT_LT((of_a->uv - of_b->uv).length(), 1e-4F);
            const auto bsdf_a = bsdf_at(a, *of_a);
            const auto bsdf_b = bsdf_at(b, *of_b);
            EXPECT_EQ(bsdf_a.has_value(), bsdf_b.has_value());
            if (bsdf_a && bsdf_b) expect_same(*bsdf_a, *bsdf_b);
        }
    return hits;
}

/// The same lights, with the same power at several wavelengths.
inline void expect_same_lights(const Scene& a, const Scene& b, double tolerance = 1e-5) {
    ASSERT_EQ(a.lights().size(), b.lights().size());
    for (std::size_t i = 0; i < a.lights().size(); ++i) {
        const Light& of_a = a.lights()[i];
        const Light& of_b = b.lights()[i];
        EXPECT_EQ(name_of(of_a), name_of(of_b));
        for (const float nm : {400.0F, 517.3F, 600.0F, 702.1F}) {
            const double wanted = power(of_a, a.sphere()) * static_cast<double>(curve(of_a)(nm));
            const double got = power(of_b, b.sphere()) * static_cast<double>(curve(of_b)(nm));
            EXPECT_NEAR(got, wanted, tolerance * std::abs(wanted)) << name_of(of_a) << nm;
        }
    }
}

/// Reads a scene, writes it, reads that, and compares all of both. @return how many rays hit.
inline int expect_same_again(const std::string& text, const MemoryFiles& files = {}) {
    const SceneDescription first = read_text(text, files);
    const SceneDescription second = again(first);
    EXPECT_EQ(second.shapes.size(), first.shapes.size());
    EXPECT_EQ(second.instances.size(), first.instances.size());
    const Scene a{SceneDescription(first)};
    const Scene b{SceneDescription(second)};
    expect_same_lights(a, b);
    return expect_same_hits(a, b);
}

}  // namespace sunfleck::engine
