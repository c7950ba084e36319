// The reading from its first statement to the finished scene.
#include "import/pbrt/reader.h"

#include "core/file_content.h"
#include "geometry/affine.h"
#include "import/pbrt/camera.h"
#include "import/pbrt/directives.h"
#include "import/pbrt/film.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/scene_materials.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <filesystem>

namespace sunfleck::engine {
namespace {

/// Rays in the frame of such an instance would be out of the range of their floats.
bool is_extreme(const Matrix& to_world) {
    constexpr double kMost = 1e10;
    const auto is_far = [](const Affine& map) {
        return std::max({map.x.length(), map.y.length(), map.z.length()}) > kMost;
    };
    const Affine map(to_world);
    return is_far(map) || is_far(map.inverse());
}

void finish_instances(Reading& reading) {
    for (const InstanceUse& use : reading.instances) {
        const auto found = reading.objects.find(use.name);
        if (found == reading.objects.end())
            throw Error(use.where, "there is no object " + in_quotes(use.name),
                        "make it by ObjectBegin and ObjectEnd");
        if (is_extreme(use.to_world))
            reading.log.warn(use.where,
                             "an instance whose size is less than 10^-10 or more than 10^10 "
                             "of its object's is left out");
        else
            reading.scene.instances.push_back({found->second, use.to_world});
    }
}

/// Interfaces do not shine (pbrt-v4), but for lights that nothing can meet.
void finish_emission(Reading& reading) {
    for (ShapeDescription& shape : reading.scene.shapes) {
        const Material& material = reading.scene.materials[shape.material];
        const bool straight = std::holds_alternative<InterfaceMaterial>(material);
        if (!shape.emission || !straight || shape.unseen) continue;
        shape.emission.reset();
        reading.log.warn(shape.where, "area lights on interfaces are ignored, as in pbrt-v4");
    }
}

/// What has to wait until all statements are known.
void finish(Reading& reading) {
    reading.check_blocks_closed(0);
    if (!reading.in_world)
        throw Error({reading.scene.path}, "there is no WorldBegin",
                    "write it after the camera, and shapes and lights after it");
    finish_film(reading);
    finish_camera(reading);
    finish_filter(reading);
    finish_guide_samples(reading);
    finish_materials(reading.materials, reading.assets, reading.scene);
    finish_emission(reading);
    reading.media.finish(reading.assets.spectra, reading.log, reading.scene.media);
    finish_instances(reading);
    reading.assets.images.load();
    reading.warn_unused_defaults();
    reading.scene.warnings = reading.log.warnings();
    reading.scene.words = reading.log.words();
    reading.scene.files = reading.assets.files.paths();
}

SceneDescription read_all(std::string text, const std::string& path, const FileAccess& files) {
    refuse_other_content(text, path, "a scene of pbrt-v4");
    Reading reading(path, files);
    TokenStream tokens;
    tokens.push(std::move(text), std::filesystem::path(path).lexically_normal().string(), {path});
    try {
        read_statements(reading, tokens);
        finish(reading);
    } catch (const Error&) {
        reading.assets.files.check_missing();  // this fault may come of what is missing
        throw;
    }
    reading.assets.files.check_missing();
    return std::move(reading.scene);
}

}  // namespace

SceneDescription read_pbrt(const std::string& path) {
    const FileAccess files = disk_access();
    return read_all(files(path, {path}), path, files);
}

SceneDescription read_pbrt_input() {
    const std::string name(kStandardInput);
    const std::string text = unpacked(read_standard_input(name), name);
    SceneDescription scene = read_all(text, name, disk_access());
    scene.text = text;
    return scene;
}

SceneDescription read_pbrt_text(const std::string& text, const std::string& path) {
    return read_all(text, path, disk_access());
}

SceneDescription read_pbrt_text(const std::string& text, const std::string& path,
                                const FileAccess& files) {
    return read_all(text, path, files);
}

}  // namespace sunfleck::engine
