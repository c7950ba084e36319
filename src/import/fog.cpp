// The medium of fog, and who is in it.
#include "import/fog.h"

#include "import/medium_border.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Where fog ends, before light that comes from afar.
constexpr double kFogOverRadius = 1.2;

/// Puts fog in place of empty space.
class Filler {
public:
    Filler(const std::vector<Material>& materials, MediumNumber fog)
        : materials_(materials), fog_(fog) {}

    void fill(MediumNumber& medium) const {
        if (medium == 0) medium = fog_;
    }
    void fill(MediumSides& sides) const {
        fill(sides.inside);
        fill(sides.outside);
    }
    /// Glass without a medium of its own keeps its inside clear.
    void fill(std::vector<ShapeDescription>& shapes) const {
        for (ShapeDescription& shape : shapes) {
            const bool is_glass =
                std::holds_alternative<DielectricMaterial>(materials_[shape.material]);
            if (is_glass && !shape.media.differ() && shape.media.inside == 0)
                fill(shape.media.outside);
            else
                fill(shape.media);
        }
    }

private:
    const std::vector<Material>& materials_;
    MediumNumber fog_;
};

}  // namespace

void fill_with_fog(SceneDescription& scene, const Fog& fog) {
    const double events = 1 / fog.mean_free_path;
    const auto constant = [](double value) {
        return Spectrum::constant(static_cast<float>(value));
    };
    Media& media = scene.media;
    media.all.push_back({constant(events * (1 - fog.albedo)), constant(events * fog.albedo),
                         static_cast<float>(fog.g)});
    const auto number = static_cast<MediumNumber>(media.all.size() - 1);
    const Filler filler(scene.materials, number);
    filler.fill(media.at_camera);
    media.at_lights.resize(scene.lights.size());
    for (MediumSides& sides : media.at_lights) filler.fill(sides);
    filler.fill(scene.shapes);
    for (std::vector<ShapeDescription>& object : scene.objects) filler.fill(object);
    if (std::any_of(scene.lights.begin(), scene.lights.end(), comes_from_afar))
        end_at_sphere(scene, number, kFogOverRadius);
}

}  // namespace sunfleck::engine
