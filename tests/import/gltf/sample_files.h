// Public glTF samples of ../shared/data, which tests skip where they are absent; and what rays see.
#pragma once

#include "gltf_files.h"
#include "medium/free_path.h"
#include "scene/scene.h"

#include <optional>

namespace sunfleck::engine::testing_support {

/// A test of a public sample file.
class GltfSample : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::is_directory(folder())) GTEST_SKIP() << folder() << " is not here";
    }

    static std::string folder() {
        return std::string(SUNFLECK_SOURCE_DIR) + "/../shared/data/gltf/";
    }
    static SceneDescription sample(const std::string& name, const ImportSettings& settings = {}) {
        return read_gltf(folder() + name, settings);
    }

    /// Sixteen wavelengths' worth of two passes: few enough, and spread over the visible.
    static Wavelengths probe_wavelengths() {
        Wavelengths w;
        for (std::size_t i = 0; i < kWavelengths; ++i)
            w.nm.at(i) = 430 + 35 * static_cast<float>(i);
        return w;
    }
};

/// What rays of the world hit.
class Probed {
public:
    explicit Probed(SceneDescription description) : scene_(std::move(description)) {}

    const Scene& scene() const { return scene_; }
    std::optional<Hit> hit(const Vec3d& from, const Vec3d& direction) const {
        return scene_.geometry().intersect(
            Ray{Vec3(from - scene_.origin()), Vec3(direction.normalized()), kInfinity});
    }
    const Material& material(const Hit& hit) const {
        return scene_.materials()[scene_.material_of(hit)];
    }
    /// Returns the base colour at a hit, if it is plastic or metal.
    SampledSpectrum colour(const Hit& hit, const Wavelengths& wavelengths) const {
        const TexturePoint point(hit, scene_.origin());
        if (const auto* plastic = std::get_if<CoatedDiffuseMaterial>(&material(hit)))
            return plastic->reflectance.at(point, wavelengths);
        if (const auto* metal = std::get_if<ConductorMaterial>(&material(hit)))
            return metal->reflectance->at(point, wavelengths);
        return SampledSpectrum(-1);
    }
    /// Returns what absorption leaves of a straight way from a hit to the next surface.
    SampledSpectrum left_behind(const Hit& hit, const Vec3d& direction,
                                const Wavelengths& wavelengths) const {
        const Vec3 along(direction.normalized());
        const MediumNumber medium = scene_.medium_beyond(hit, along, 0);
        const Vec3 from = offset_origin(hit.position, hit.normal, hit.error, along);
        const auto next = scene_.geometry().intersect(Ray{from, along, kInfinity});
        if (!next) return SampledSpectrum(-1);
        return transmittance(sampled(scene_.media().all.at(medium), wavelengths),
                             {from, along, next->distance});
    }

private:
    Scene scene_;
};

}  // namespace sunfleck::engine::testing_support
