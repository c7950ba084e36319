// Meshes of the three formats as one form; their materials; what is left open.
#include "import/part/reader.h"

#include "core/printable.h"
#include "core/small_letters.h"
#include "import/obj/reader.h"
#include "import/obj/smoothing.h"
#include "import/part/libraries.h"
#include "import/part/shapes.h"
#include "import/part/surroundings.h"
#include "import/ply/reader.h"
#include "import/stl/reader.h"
#include "material/named_materials.h"
#include "scene/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace sunfleck::engine {
namespace {

enum class PartFormat { obj, stl, ply, none };

PartFormat format_of_part(const std::string& path) {
    const std::string ending = small_ending(path);
    if (ending == ".obj") return PartFormat::obj;
    if (ending == ".stl") return PartFormat::stl;
    return ending == ".ply" ? PartFormat::ply : PartFormat::none;
}

ObjMesh as_obj(StlMesh stl) {
    ObjMesh mesh;
    mesh.positions.reserve(stl.positions.size());
    for (const Vec3& p : stl.positions) mesh.positions.emplace_back(p);
    mesh.triangles = std::move(stl.triangles);
    mesh.runs = {ObjRun{}};
    mesh.remarks = std::move(stl.remarks);
    return mesh;
}

ObjMesh as_obj(PlyMesh ply) {
    ObjMesh mesh;
    mesh.positions = std::move(ply.positions);
    mesh.triangles = std::move(ply.triangles);
    mesh.runs = {ObjRun{}};
    mesh.remarks = std::move(ply.remarks);
    mesh.uvs = std::move(ply.uvs);
    if (!mesh.uvs.empty()) mesh.uv_corners = mesh.triangles;
    mesh.colours = std::move(ply.colours);
    mesh.normals = std::move(ply.normals);
    if (mesh.normals.empty()) return mesh;
    mesh.normal_corners = mesh.triangles;
    const std::size_t broken = drop_broken_normals(mesh);
    if (broken > 0)
        mesh.remarks.push_back(
            fmt::format("triangles whose normals are zero or not finite are flat ({})", broken));
    return mesh;
}

ObjMesh read_mesh(const std::string& path) {
    const std::string bytes = read_input_file(path, {path});
    switch (format_of_part(path)) {
        case PartFormat::obj:
            return parse_obj(bytes, path);
        case PartFormat::stl:
            return as_obj(parse_stl(bytes, path));
        default:
            return as_obj(parse_ply(bytes, path));
    }
}

/// The looks of a part, made when they are first asked for.
class PartLooks {
public:
    PartLooks(SceneDescription& scene, const ObjMesh& mesh, const PartLibraries& libraries,
              PartPictures& pictures, const ImportSettings& settings)
        : scene_(scene),
          names_(mesh.materials),
          has_colours_(!mesh.colours.empty()),
          libraries_(libraries),
          pictures_(pictures),
          settings_(settings) {}

    const PartLook& operator()(std::uint32_t index) {
        const auto known = looks_.find(index);
        if (known != looks_.end()) return known->second;
        return looks_.emplace(index, made(index)).first->second;
    }

    bool take_vertex_colours() const {
        return std::any_of(looks_.begin(), looks_.end(),
                           [](const auto& look) { return look.second.takes_vertex_colours; });
    }

private:
    PartLook made(std::uint32_t index) {
        if (index == kNoIndex) return usual_look();
        const ObjName& name = names_[index];
        const auto found = libraries_.find(name.name);
        if (found)
            return named_look(look_of(*found->material, *found->library, pictures_, scene_),
                              name.name);
        if (!libraries_.are_missing())
            scene_.warnings.add(name.where, "there is no material " + in_quotes(name.name) +
                                                " in the part's libraries");
        return (*this)(kNoIndex);
    }

    /// Names the materials of a look.
    PartLook named_look(PartLook look, const std::string& name) {
        name_material(scene_, look.material, name);
        if (look.glass) name_material(scene_, look.glass->pane, name);
        return look;
    }

    PartLook usual_look() {
        if (settings_.material.empty() && has_colours_) {
            scene_.warnings.add({scene_.path},
                                "there is no material: the colours of its vertices are used, matt "
                                "(--material)");
            PartLook look;
            look.takes_vertex_colours = true;
            return look;
        }
        if (settings_.material.empty())
            scene_.warnings.add({scene_.path},
                                "there is no material: light grey plastic is used (--material)");
        const std::string name = settings_.material.empty() ? "plastic" : settings_.material;
        const NamedMaterial named = named_material(name, {"--material"});
        PartLook look;
        look.material = add_material(scene_, named.material);
        if (!named.is_clear) return named_look(look, name);
        PartLook::Glass glass;
        glass.pane = add_material(
            scene_, ThinDielectricMaterial{std::get<DielectricMaterial>(named.material).eta});
        if (named.absorption) glass.medium = add_medium(scene_, *named.absorption);
        look.glass = glass;
        return named_look(look, name);
    }

    SceneDescription& scene_;
    std::vector<ObjName> names_;
    bool has_colours_;  // of vertices
    const PartLibraries& libraries_;
    PartPictures& pictures_;
    const ImportSettings& settings_;
    std::map<std::uint32_t, PartLook> looks_;
};

std::string unit_text(double metres) {
    for (const auto& [unit, size] : {std::pair("m", 1.0), std::pair("cm", 0.01),
                                     std::pair("mm", 0.001), std::pair("in", 0.0254)})
        if (size == metres) return unit;
    return fmt::format("{:g} m", metres);
}

double metres_per_unit(const std::string& path, const ImportSettings& settings) {
    constexpr double kMillimetre = 0.001;
    const double usual = format_of_part(path) == PartFormat::stl ? kMillimetre : 1;
    return settings.metres_per_unit.value_or(usual);
}

void tell_frame(SceneDescription& scene, const Bounds& bounds, const ImportSettings& settings) {
    if (settings.up && settings.metres_per_unit) return;
    const Vec3d size = (bounds.max - bounds.min) / metres_per_unit(scene.path, settings);
    const std::string unit = unit_text(metres_per_unit(scene.path, settings));
    const bool is_z = up_of_part(scene.path, settings) == UpAxis::z;
    scene.warnings.add({scene.path},
                       fmt::format("its axes and unit are taken as {} up and {}: it is "
                                   "{:.4g} x {:.4g} x {:.4g} {} (--up, --unit)",
                                   is_z ? "z" : "y", unit, size.x, size.y, size.z, unit));
}

}  // namespace

bool is_part(const std::string& path) {
    return format_of_part(path) != PartFormat::none;
}

UpAxis up_of_part(const std::string& path, const ImportSettings& settings) {
    return settings.up.value_or(format_of_part(path) == PartFormat::stl ? UpAxis::z : UpAxis::y);
}

SceneDescription read_part(const std::string& path, const ImportSettings& settings) {
    ObjMesh mesh = read_mesh(path);
    SceneDescription scene;
    scene.path = path;
    scene.film.imaging_ratio = static_cast<float>(kLumensPerWatt);  // a pixel of 1 is 1 cd/m2
    for (const std::string& remark : mesh.remarks) scene.warnings.add({path}, remark);
    PartFiles files(path);
    PartPictures pictures(files, scene.warnings);
    const PartLibraries libraries(files, mesh.libraries, scene.warnings);
    PartLooks looks(scene, mesh, libraries, pictures, settings);
    // All looks first: they name files, of which all that are missing are told at once.
    for (const ObjRun& run : mesh.runs) looks(run.material);
    libraries.check_missing(files, settings, scene.warnings);
    if (!mesh.colours.empty() && !looks.take_vertex_colours())
        scene.warnings.add({path}, "colours of vertices are left out: it has a material");
    add_part_shapes(scene, std::move(mesh), {metres_per_unit(path, settings), settings.glass},
                    [&](std::uint32_t index) -> const PartLook& { return looks(index); });
    const Bounds bounds = bounds_of_scene(scene);
    const UpAxis up = up_of_part(path, settings);
    tell_frame(scene, bounds, settings);
    set_part_view(scene, up);
    if (settings.ground) add_ground(scene, bounds, up);
    scene.files = files.files();
    return scene;
}

}  // namespace sunfleck::engine
