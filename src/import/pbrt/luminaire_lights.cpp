// Luminaires of pbrt's scenes.
#include "import/pbrt/luminaire_lights.h"

#include "core/small_letters.h"
#include "import/ies/light.h"
#include "import/pbrt/light_images.h"
#include "import/pbrt/light_scale.h"
#include "import/pbrt/reading.h"
#include "light/lumens.h"

#include <utility>

namespace sunfleck::engine {

bool names_luminaire(const Statement& statement) {
    const auto name = statement.text("filename");
    return name && small_letters(*name).ends_with(".ies");
}

Light luminaire_light(const Statement& statement, Reading& reading) {
    const std::string name = *statement.text("filename");
    const auto map = reading.assets.files.read_as(
        name, statement.find("filename")->where,
        [](const NamedFile& file) { return intensity_map(Photometry(file.bytes, file.path)); });
    Affine to_world = turn_of(statement, reading);
    std::swap(to_world.y, to_world.z);
    const double at_one = 4 * kPiDouble * map->mean();
    const Spectrum colour = emission_of(statement, "I", reading);
    const Spectrum curve =
        scaled_emission(statement, colour.scaled(static_cast<float>(1 / kLumensPerWatt)),
                        {"power", at_one / kLumensPerWatt}, map->peak());
    return GoniometricLight{curve, Affine(reading.still_matrix(statement.where)).origin, map,
                            to_world};
}

}  // namespace sunfleck::engine
