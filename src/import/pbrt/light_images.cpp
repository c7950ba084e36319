// Reading and checking of images for lights.
#include "import/pbrt/light_images.h"

#include "image/read_image.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"
#include "light/affine_area.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

std::string size_text(const Vec2i& size) {
    return std::to_string(size.x) + " x " + std::to_string(size.y);
}

}  // namespace

Image light_image(const Statement& statement, Reading& reading) {
    const auto name = statement.text("filename");
    if (!name || name->empty())
        throw Error(statement.where, "a light without its image", "add \"string filename\"");
    const SourceLocation& where = statement.find("filename")->where;
    return reading.assets.files.read_as(*name, where, [&](const NamedFile& file) {
        Image image = parse_image(file.bytes, file.path);
        image.mend_broken();
        warn_of_image(image, file.path, where, reading.log);
        return image;
    });
}

EnvironmentImage environment_image(const Statement& statement, Reading& reading) {
    Image image = light_image(statement, reading);
    const auto map = map_of_size(image.resolution());
    const SourceLocation& where = statement.find("filename")->where;
    if (!map)
        throw Error(where,
                    "the image of a light has " + size_text(image.resolution()) +
                        " texels, but an equal-area map of directions is square, and one of "
                        "latitude and longitude twice as wide as high",
                    "use one of these");
    if (!map->has_equal_areas())
        reading.log.warn(where,
                         "the picture is a map of latitude and longitude, which is taken as it is; "
                         "pbrt-v4 wants an equal-area one");
    return {std::move(image), *map};
}

std::shared_ptr<const LightImage> intensity_image(const Statement& statement, Reading& reading) {
    const Image image = light_image(statement, reading);
    const Vec2i& size = image.resolution();
    if (size.x != size.y)
        throw Error(statement.find("filename")->where,
                    "the image of a light has " + size_text(size) +
                        " texels, but an equal-area map of directions is square",
                    "convert it, for example with pbrt-v4's imgtool makeequiarea");
    std::vector<float> means;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const Vec3 rgb = image.rgb(x, y);
            means.push_back((rgb.x + rgb.y + rgb.z) / 3);
        }
    return std::make_shared<const LightImage>(Image(size, 1, std::move(means)));
}

Affine turn_of(const Statement& statement, Reading& reading) {
    const Affine given(reading.still_matrix(statement.where));
    if (!given.is_invertible())
        throw Error(statement.where, "the matrix of the light is singular",
                    "use scales other than zero");
    if (!is_similarity(given))
        reading.log.warn(statement.where,
                         "a light with an image uses the rotation of its matrix alone: scale and "
                         "shear are ignored");
    Affine turn;
    turn.x = given.x.normalized();
    turn.y = (given.y - turn.x * turn.x.dot(given.y)).normalized();
    turn.z = turn.x.cross(turn.y) * (given.determinant() < 0 ? -1 : 1);
    return turn;
}

}  // namespace sunfleck::engine
