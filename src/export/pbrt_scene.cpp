// The order of statements: view, media, textures, materials, lights, shapes, objects, instances.
#include "export/pbrt_scene.h"

#include "export/coordinates.h"
#include "export/lights.h"
#include "export/masks.h"
#include "export/materials.h"
#include "export/meshes.h"
#include "export/spectra.h"
#include "export/view.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <utility>

namespace sunfleck::engine {
namespace {

std::string medium_name(MediumNumber number) {
    return number == 0 ? "" : fmt::format("medium-{}", number);
}

std::string interface_text(const MediumSides& sides) {
    if (sides == MediumSides{}) return {};
    return fmt::format("MediumInterface \"{}\" \"{}\"\n", medium_name(sides.inside),
                       medium_name(sides.outside));
}

/// Quadrics and curves that do not emit are turned where their matrix mirrors, as pbrt-v4 does.
bool turns_where_mirrored(const ShapeDescription& shape) {
    return !shape.emission && !std::holds_alternative<TriangleMesh>(shape.placed.shape) &&
           !std::holds_alternative<BilinearMesh>(shape.placed.shape) &&
           Affine(shape.placed.to_world).determinant() < 0;
}

class PbrtWriter {
public:
    PbrtWriter(const SceneDescription& scene, std::string name)
        : scene_(scene),
          name_(std::move(name)),
          pictures_(folder(), result_.files),
          textures_(pictures_, result_.warnings, {scene.path}),
          materials_(scene.materials, scene.bump_maps, pictures_, textures_),
          lights_(pictures_, result_.warnings),
          shapes_(folder(), result_.files) {}

    ExportedScene write() {
        const std::string lights = lights_text();
        const std::string shapes = shapes_text();  // makes textures and materials
        const std::string picture = std::filesystem::path(name_).stem().string() + ".exr";
        const MediumSides at_camera{scene_.media.at_camera, scene_.media.at_camera};
        const std::string camera =
            camera_text(scene_.camera, interface_text(at_camera), {scene_.path}, result_.warnings);
        const std::string media = media_text();
        std::string text = "# Written by Sunfleck.\n" + media + camera +
                           film_text(scene_.film, picture) + filter_text(scene_.filter) +
                           integrator_text(scene_) + "\nWorldBegin\n";
        if (at_camera != MediumSides{}) text += "MediumInterface \"\" \"\"\n";  // it goes on
        for (const std::string* part : {&textures_.text(), &materials_.text(), &lights, &shapes})
            if (!part->empty()) text += '\n' + *part;
        result_.files.push_back({name_, [text = std::move(text)] { return text; }});
        return std::move(result_);
    }

private:
    std::string folder() const { return std::filesystem::path(name_).stem().string() + "-files"; }

    /// Returns a medium as it is written: alike everywhere.
    Medium written(std::size_t number) {
        Medium medium = scene_.media.all[number];
        if (medium.glow && medium.glow->varies()) {
            result_.warnings.add({scene_.path},
                                 medium_name(static_cast<MediumNumber>(number)) +
                                     " emits by place, which is not written: it is dark");
            medium.glow = nullptr;
        }
        if (!medium.density) return medium;
        result_.warnings.add({scene_.path},
                             medium_name(static_cast<MediumNumber>(number)) +
                                 " varies in space, which is not written: it has the mean of its "
                                 "density everywhere");
        const float density = mean(*medium.density);
        medium.absorption = medium.absorption.scaled(density);
        medium.scattering = medium.scattering.scaled(density);
        return medium;
    }

    std::string media_text() {
        std::string text;
        for (std::size_t i = 1; i < scene_.media.all.size(); ++i) {
            const Medium medium = written(i);
            StatementText statement("MakeNamedMedium", medium_name(static_cast<MediumNumber>(i)));
            statement.add_word("string", "type", "homogeneous");
            add_spectrum(statement, "sigma_a", medium.absorption, ColourUse::unbounded);
            if (scatters(medium)) {
                add_spectrum(statement, "sigma_s", medium.scattering, ColourUse::unbounded);
                statement.add("g", medium.g);
            } else {
                statement.add("rgb", "sigma_s", Vec3(0));
            }
            if (medium.glow) add_emission(statement, "Le", medium.glow->radiance, "Lescale");
            text += statement.text();
        }
        return text;
    }

    std::string lights_text() {
        std::string text;
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            const std::uint32_t from = i < scene_.stated_in.size() ? scene_.stated_in[i] : kNone;
            const SourceLocation where =
                from == kNone ? SourceLocation{scene_.path} : scene_.light_statements[from].where;
            const auto& around = scene_.media.at_lights;
            const std::string inside =
                i < around.size() ? interface_text({around[i].outside, around[i].outside}) : "";
            const std::string light = lights_.of(scene_.lights[i], where);
            text += inside.empty()
                        ? light
                        : fmt::format("AttributeBegin\n{}{}AttributeEnd\n", inside, light);
        }
        return text;
    }

    std::string shapes_text() {
        std::string text;
        for (const ShapeDescription& shape : scene_.shapes) text += shape_text(shape);
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) text += object_text(i);
        for (const InstanceDescription& instance : scene_.instances)
            text += "AttributeBegin\n" + transform_text(instance.to_world) + "ObjectInstance \"" +
                    object_name(instance.object) + "\"\nAttributeEnd\n";
        return text;
    }

    static std::string object_name(std::size_t number) {
        return fmt::format("object-{}", number + 1);
    }

    std::string object_text(std::size_t number) {
        std::string text = "ObjectBegin \"" + object_name(number) + "\"\n";
        for (const ShapeDescription& shape : scene_.objects[number]) text += shape_text(shape);
        return text + "ObjectEnd\n";
    }

    std::string shape_text(const ShapeDescription& shape) {
        const auto mapping = common_mapping(shape, scene_.materials, scene_.bump_maps);
        const Mapping* of_mesh = mapping ? &*mapping : nullptr;
        textures_.set_mapping_of_meshes(of_mesh);
        std::string text = "AttributeBegin\n" + transform_text(shape.placed.to_world);
        if (shape.placed.flip != turns_where_mirrored(shape)) text += "ReverseOrientation\n";
        text += interface_text(shape.media) + materials_.use(shape.material);
        if (shape.emission) text += lights_.area(*shape.emission);
        for (StatementText& statement : shapes_.of(shape.placed.shape, of_mesh)) {
            add_alpha(statement, shape);
            text += statement.text();
        }
        return text + "AttributeEnd\n";
    }

    void add_alpha(StatementText& statement, const ShapeDescription& shape) {
        if (shape.unseen) return statement.add("alpha", 0.0F);
        if (shape.alpha) return textures_.add(statement, "alpha", *shape.alpha);
        if (!shape.placed.cover) return;
        result_.warnings.add(shape.where,
                             fmt::format("a mask by a limit of alpha is written as a picture of "
                                         "{0} x {0} texels",
                                         kMaskSide));
        const auto key = std::pair{shape.material, uv_box(shape.placed)};
        auto known = masks_.find(key);
        if (known == masks_.end())
            known = masks_.emplace(key, mask_of(shape.placed.cover, key.second)).first;
        textures_.add(statement, "alpha", known->second);
    }

    const SceneDescription& scene_;
    std::string name_;
    ExportedScene result_;
    PictureFiles pictures_;
    TextureWriter textures_;
    MaterialWriter materials_;
    LightStatements lights_;
    ShapeStatements shapes_;
    std::map<std::pair<std::uint32_t, UvBox>, FloatTexture> masks_;
};

}  // namespace

ExportedScene pbrt_scene(const SceneDescription& scene, const std::string& name) {
    return PbrtWriter(scene, name).write();
}

}  // namespace sunfleck::engine
