// Completion of a reading: what had to wait until all statements are known.
#include "import/pbrt/finish.h"

#include "geometry/affine.h"
#include "geometry/extent.h"
#include "import/pbrt/camera.h"
#include "import/pbrt/film.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/scene_materials.h"
#include "import/pbrt/subsurface_media.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns whether rays in the frame of such an instance would overflow floats.
bool is_extreme(const Matrix& to_world) {
    constexpr double kMost = 1e10;
    const auto is_far = [](const Affine& map) {
        return std::max({map.x.length(), map.y.length(), map.z.length()}) > kMost;
    };
    const Affine map(to_world);
    return is_far(map) || is_far(map.inverse()) ||
           !(absolute_dot(map.origin, Vec3d(1)) < kLargestExtent);
}

void finish_instances(Reading& reading) {
    for (const InstanceUse& use : reading.instances) {
        const auto found = reading.objects.find(use.name);
        if (found == reading.objects.end())
            throw Error(use.where, "there is no object " + in_quotes(use.name),
                        "make the object, or name another: " +
                            did_you_mean(names_of(reading.objects), use.name));
        if (is_extreme(use.to_world))
            reading.log.warn(use.where,
                             "an instance was left out: its scale is below 10^-10 "
                             "or above 10^10, or its place is beyond 10^17");
        else
            reading.scene.instances.push_back({found->second, use.to_world, use.name});
    }
}

/// Interfaces do not emit (pbrt-v4), except for area lights of alpha zero.
void finish_emission(Reading& reading) {
    for (ShapeDescription& shape : reading.scene.shapes) {
        const Material& material = reading.scene.materials[shape.material];
        const bool straight = std::holds_alternative<InterfaceMaterial>(material);
        if (!shape.emission || !straight || shape.unseen) continue;
        shape.emission.reset();
        reading.log.warn(shape.where, "area lights on interfaces are ignored, as in pbrt-v4");
    }
}

/// Completes what had to wait until all statements are known.
void finish(Reading& reading) {
    reading.check_blocks_closed(0);
    if (!reading.in_world)
        throw Error({reading.scene.path}, "there is no WorldBegin",
                    "write it after the camera, and shapes and lights after it");
    finish_film(reading);
    finish_camera(reading);
    finish_filter(reading);
    finish_hints(reading);
    finish_materials(reading.materials, reading.assets, reading.scene);
    finish_emission(reading);
    reading.media.finish(reading.assets, reading.scene.media);
    fill_subsurface(reading.materials, reading.assets, reading.scene);
    finish_instances(reading);
    reading.assets.images.load();
    reading.warn_unused_defaults();
    reading.scene.warnings = reading.log.warnings();
    reading.scene.words = reading.log.words();
    reading.scene.files = reading.assets.files.paths();
}

}  // namespace

SceneDescription finish_scene(Reading& reading) {
    try {
        finish(reading);
    } catch (const Error&) {
        reading.assets.files.check_missing();  // this fault may come of what is missing
        throw;
    }
    reading.assets.files.check_missing();
    return std::move(reading.scene);
}

}  // namespace sunfleck::engine
