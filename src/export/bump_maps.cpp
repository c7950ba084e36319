// Bump maps and normal maps of materials.
#include "export/materials.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns a normal map whose slopes are multiplied by a factor.
std::shared_ptr<const Image> steeper(const Image& image, float strength) {
    std::vector<float> texels;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x) {
            const Vec3 v = image.rgb(x, y);
            texels.insert(texels.end(),
                          {0.5F + (v.x - 0.5F) * strength, 0.5F + (v.y - 0.5F) * strength, v.z});
        }
    return std::make_shared<const Image>(image.resolution(), 3, std::move(texels));
}

bool is_plain(const Mapping& mapping) {
    const auto* uv = std::get_if<UvMapping>(&mapping);
    return uv != nullptr && uv->scale == Vec2(1) && uv->shift == Vec2(0);
}

}  // namespace

void MaterialWriter::add_bump_map(StatementText& statement, const BumpMap& bump_map) {
    if (const auto* bumps = std::get_if<DisplacementMap>(&bump_map))
        textures_.add(statement, "displacement", bumps->displacement);
    const auto* normals = std::get_if<NormalMap>(&bump_map);
    if (!normals) return;
    if (!is_plain(normals->mapping) || normals->wraps.across != Wrap::repeat ||
        normals->wraps.down != Wrap::repeat)
        textures_.warn(
            "a normal map lies on the coordinates of the mesh as they are, and repeats: "
            "its own mapping is left out");
    if (normals->follows_v)
        textures_.warn(
            "green of a normal map goes along normal x dp/du in pbrt-v4: where the "
            "coordinates of a mesh are mirrored, slopes are turned");
    const auto image =
        normals->strength == 1 ? normals->image : steeper(*normals->image, normals->strength);
    statement.add_word("string", "normalmap", pictures_.linear(image));
}

}  // namespace sunfleck::engine
