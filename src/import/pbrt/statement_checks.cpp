// Trial conversions, whose results, warnings and lists of files are dropped.
#include "import/pbrt/statement_checks.h"

#include "import/pbrt/camera.h"
#include "import/pbrt/film.h"
#include "import/pbrt/material_table.h"
#include "import/pbrt/materials.h"
#include "import/pbrt/medium_table.h"
#include "import/pbrt/reading.h"

#include <memory>

namespace sunfleck::engine {
namespace {

Statement without_textures(Statement statement) {
    std::erase_if(statement.own,
                  [](const auto& parameter) { return parameter->type == ParameterType::texture; });
    return statement;
}

/// Calls convert(assets) with assets of its own. Missing files are told at the end of the scene.
template <class Convert>
void try_with_assets(const std::string& path, const Convert& convert) {
    LoggedAssets own(path, disk_access());
    try {
        convert(own.assets);
    } catch (const MissingFile&) {
    }
}

/// Returns a statement whose parameter "value" is the texture of that name.
Statement use_of(const std::string& texture, const SourceLocation& where) {
    Parameter parameter;
    parameter.type = ParameterType::texture;
    parameter.name = "value";
    parameter.where = where;
    parameter.texts = {texture};
    return {"Texture", texture, where, {std::make_shared<const Parameter>(parameter)}, nullptr};
}

}  // namespace

void check_camera(const Statement& camera, const Matrix& to_world) {
    ImportLog log;
    camera_of(camera, to_world, FilmDescription().resolution);
    exposure_time_of(camera, log);
}

void check_film(const Statement& film) {
    ImportLog log;
    film_of(film, log);
}

void check_filter(const Statement& filter) {
    filter_of(filter);
}

void StatementChecks::material(const std::string& name, const Statement& material) const {
    MaterialTable table;
    table.make(name, without_textures(material));
    try_with_assets(path_, [&](Assets& assets) {
        const Statement& statement = table.named(name, material.where);
        material_of(statement, assets);
        bump_map_of(statement, assets);
    });
}

void StatementChecks::medium(const Statement& medium) const {
    MediumTable table;
    table.make(medium);
    table.number_of(medium.type, medium.where);
    try_with_assets(path_, [&](Assets& assets) {
        Media media;
        table.finish(assets, media);
    });
}

void StatementChecks::texture(const std::string& kind, const std::string& name,
                              const Statement& texture, const Matrix& to_world) const {
    try_with_assets(path_, [&](Assets& assets) {
        assets.textures.add(kind, name, without_textures(texture), to_world);
        const Statement use = use_of(name, texture.where);
        if (kind == "float")
            assets.textures.find_number(use, "value");
        else
            assets.textures.find_spectrum(use, "value", SpectrumUse::reflectance);
    });
}

}  // namespace sunfleck::engine
