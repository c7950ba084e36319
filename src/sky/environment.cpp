// Reading and placing of environment pictures.
#include "sky/environment.h"

#include "core/input_file.h"
#include "image/read_image.h"
#include "scene/additions.h"

namespace sunfleck::engine {

void add_environment(SceneDescription& scene, const EnvironmentPicture& picture,
                     const Affine& axes) {
    const SourceLocation where{picture.file};
    Image image = parse_image(read_input_file(picture.file, where), picture.file);
    const Vec2i size = image.resolution();
    const auto map = map_of_size(size);
    if (!map)
        throw Error(where,
                    "has " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                        " pixels, which is no map of all directions",
                    "use one of latitude and longitude, twice as wide as high, or a square one of "
                    "equal areas");
    image.mend_broken();
    if (const std::size_t broken = image.broken().count; broken > 0)
        scene.warnings.add(where,
                           std::to_string(broken) +
                               " pixels are not finite: infinite ones become 65504, others 0");
    ImageInfiniteLight light;
    light.curve = Spectrum::d65().scaled(static_cast<float>(picture.scale));
    light.image = image_of_directions(std::move(image), *map);
    light.to_world = axes;
    light.to_world.x = -axes.x;  // seen from within, azimuths go from left to right
    light.map = *map;
    add_light(scene, {"environment", where}, std::move(light));
    scene.files.push_back(picture.file);
}

}  // namespace sunfleck::engine
