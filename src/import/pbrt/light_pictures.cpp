// Reading and checking pictures of lights.
#include "import/pbrt/light_pictures.h"

#include "image/read_image.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"
#include "light/affine_area.h"

#include <algorithm>

namespace sunfleck::engine {

Image light_image(const Statement& statement, Reading& reading) {
    const auto name = statement.text("filename");
    if (!name || name->empty())
        throw Error(statement.where, "a light without its picture", "add \"string filename\"");
    const SourceLocation& where = statement.find("filename")->where;
    return reading.assets.files.read_as(*name, where, [&](const NamedFile& file) {
        Image image = parse_image(file.bytes, file.path);
        image.mend_broken();
        warn_of_image(image, file.path, where, reading.log);
        return image;
    });
}

Image directions_image(const Statement& statement, Reading& reading) {
    Image image = light_image(statement, reading);
    const Vec2i size = image.resolution();
    if (size.x != size.y)
        throw Error(statement.find("filename")->where,
                    "the picture of a light is " + std::to_string(size.x) + " x " +
                        std::to_string(size.y) + " texels, and no equal-area map of directions",
                    "convert it to a square, as by pbrt-v4's imgtool makeequiarea");
    return image;
}

std::shared_ptr<const LightPicture> directions_picture(const Statement& statement,
                                                       Reading& reading) {
    return std::make_shared<const LightPicture>(directions_image(statement, reading));
}

std::shared_ptr<const LightPicture> intensity_picture(const Statement& statement,
                                                      Reading& reading) {
    const Image image = directions_image(statement, reading);
    const Vec2i& size = image.resolution();
    std::vector<float> means;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const Vec3 rgb = image.rgb(x, y);
            means.push_back((rgb.x + rgb.y + rgb.z) / 3);
        }
    return std::make_shared<const LightPicture>(Image(size, 1, std::move(means)));
}

Affine turn_of(const Statement& statement, Reading& reading) {
    const Affine given(reading.still_matrix(statement.where));
    if (!given.is_invertible())
        throw Error(statement.where, "the matrix of the light is singular", "scale by no zero");
    if (!is_similarity(given))
        reading.log.warn(statement.where,
                         "a light with a picture is turned by its matrix, not stretched");
    Affine turn;
    turn.x = given.x.normalized();
    turn.y = (given.y - turn.x * turn.x.dot(given.y)).normalized();
    turn.z = turn.x.cross(turn.y) * (given.determinant() < 0 ? -1 : 1);
    return turn;
}

}  // namespace sunfleck::engine
