// Shapes by their words, with the attributes of the graphics state.
#include "import/pbrt/shapes.h"

#include "import/pbrt/curve_shape.h"
#include "import/pbrt/meshes.h"
#include "import/pbrt/names.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/transforms.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

void want(bool right, const Statement& statement, std::string_view name, const std::string& fault) {
    if (right) return;
    const Parameter* found = statement.find(name);
    throw Error(found ? found->where : statement.where, statement.title() + ": " + fault,
                "check " + in_quotes(name));
}

double radius_of(const Statement& statement) {
    const double radius = statement.real("radius", 1);
    want(radius > 0, statement, "radius", "the radius is not positive");
    return radius;
}

/// Returns "phimax" in radians.
double phi_max_of(const Statement& statement) {
    const double degrees = statement.real("phimax", 360);
    want(degrees > 0, statement, "phimax", "the angle is not positive");
    return std::min(degrees / 360, 1.0) * (2 * kPiDouble);
}

LocalShape sphere(const Statement& statement, Reading&) {
    const double radius = radius_of(statement);
    const double z0 = statement.real("zmin", -radius);
    const double z1 = statement.real("zmax", radius);
    Sphere result{radius, std::max(std::min(z0, z1), -radius), std::min(std::max(z0, z1), radius),
                  phi_max_of(statement)};
    want(result.z_min < result.z_max, statement, "zmin", "nothing is left between zmin and zmax");
    return {result};
}

LocalShape disk(const Statement& statement, Reading&) {
    Disk result;
    result.height = statement.real("height", 0);
    result.radius = radius_of(statement);
    result.inner_radius = statement.real("innerradius", 0);
    result.phi_max = phi_max_of(statement);
    want(result.inner_radius >= 0 && result.inner_radius < result.radius, statement, "innerradius",
         "the inner radius is not in [0, radius)");
    return {result};
}

LocalShape cylinder(const Statement& statement, Reading&) {
    const double z0 = statement.real("zmin", -1);
    const double z1 = statement.real("zmax", 1);
    Cylinder result{radius_of(statement), std::min(z0, z1), std::max(z0, z1),
                    phi_max_of(statement)};
    want(result.z_min < result.z_max, statement, "zmin", "nothing is left between zmin and zmax");
    return {result};
}

LocalShape triangles(const Statement& statement, Reading& reading) {
    return triangle_mesh(statement, reading);
}
LocalShape ply(const Statement& statement, Reading& reading) {
    return ply_mesh(statement, reading);
}
LocalShape patches(const Statement& statement, Reading&) {
    return bilinear_mesh(statement);
}
LocalShape subdivision(const Statement& statement, Reading& reading) {
    return loop_mesh(statement, reading);
}
LocalShape curves(const Statement& statement, Reading& reading) {
    return curve(statement, reading);
}

using Maker = LocalShape (*)(const Statement&, Reading&);

struct Row {
    std::string_view word;
    Maker maker;
    Treatment treatment;
    std::string_view read_as;  // as in WordRow
};

constexpr auto kRows = std::to_array<Row>({
    {"trianglemesh", triangles, kExact, "`P`, `indices`, `N`, `uv`, `S`"},
    {"plymesh", ply, kExact,
     "triangles, normals, uv; ASCII and both binary forms; quads become two triangles each, where "
     "pbrt-v4 has a bilinear patch: one that is not flat has a crease, one without uv has others "
     "in half of it, and `power` counts both; planar convex faces of more corners are cut "
     "likewise, with a warning, and others refused; left out, with a warning: faces of fewer than "
     "three corners, vertices of no face whose numbers are not finite, normals that are no "
     "numbers, texture coordinates of faces (`texcoord`); texture coordinates that are no numbers "
     "are (0, 0), with a warning; strips of triangles (`tristrips`) are refused; its "
     "`displacement` is ignored with a warning"},
    {"sphere", sphere, kExact, "`radius zmin zmax phimax`; met exactly, in double"},
    {"disk", disk, kExact, "`height radius innerradius phimax`"},
    {"cylinder", cylinder, kExact, "`radius zmin zmax phimax`"},
    {"bilinearmesh", patches, kExact,
     "`P`, `indices`, `N`, `uv`; each patch bilinear, met exactly"},
    {"loopsubdiv", subdivision, kExact,
     "`P`, `indices`, `levels` 3; becomes triangles on the limit surface, with its normals"},
    {"curve", curves, kExact,
     "`P`, `basis` `\"bezier\"` or `\"bspline\"`, `degree` 2 or 3, `type`, `width`, `width0`, "
     "`width1`, "
     "`N`; `splitdepth` is ignored; see below"},
});

const Row& row_of(const Statement& statement) {
    const auto* const row = std::find_if(kRows.begin(), kRows.end(),
                                         [&](const Row& r) { return r.word == statement.type; });
    if (row != kRows.end()) return *row;
    throw Error(statement.where, "unknown shape " + in_quotes(statement.type),
                use_one_of(words_of(kRows), statement.type));
}

std::optional<AreaEmission> emission_here(const Statement& statement, const Shape& shape,
                                          Reading& reading) {
    if (!reading.state.emission) return std::nullopt;
    if (std::holds_alternative<Curves>(shape)) {
        reading.log.warn(statement.where, "curves emit no light");
        return std::nullopt;
    }
    if (!reading.open_object) return *reading.state.emission;
    reading.log.warn(statement.where, "area lights in objects are ignored, as in pbrt-v4");
    return std::nullopt;
}

/// Reads "alpha" of the shape, a number or a texture. @return whether the shape has any surface.
bool take_alpha(const Statement& statement, Reading& reading, ShapeDescription& shape) {
    const FloatTexture alpha = reading.assets.textures.find_number(statement, "alpha").value_or(1);
    if (alpha.is_constant() && alpha.constant() >= 1) return true;
    const bool invisible = alpha.is_constant() && !(alpha.constant() > 0);
    if (invisible) {
        shape.unseen = true;
        return shape.emission.has_value();
    }
    shape.alpha = alpha;
    shape.placed.cover = cover_by(alpha);
    return true;
}

/// Returns whether a reflection flips the normal. pbrt intersects quadrics and curves in their own
/// frame and flips the normal if the matrix mirrors: a mirrored sphere has its normal inside.
/// Meshes and patches keep the side of their own frame, and so do emitters, whose light pbrt
/// samples on that side.
bool turns_where_mirrored(const PlacedShape& placed) {
    return !std::holds_alternative<TriangleMesh>(placed.shape) &&
           !std::holds_alternative<BilinearMesh>(placed.shape) &&
           Affine(placed.to_world).determinant() < 0;
}

/// Joins consecutive curves of hair, which come as one statement per curve, into one shape.
bool joined(ShapeDescription& before, ShapeDescription& shape) {
    auto* first = std::get_if<Curves>(&before.placed.shape);
    const auto* second = std::get_if<Curves>(&shape.placed.shape);
    const bool same = first != nullptr && second != nullptr && first->kind == second->kind &&
                      before.material == shape.material && !before.placed.cover &&
                      !shape.placed.cover && before.media == shape.media &&
                      before.placed.flip == shape.placed.flip &&
                      before.placed.to_world == shape.placed.to_world;
    if (same)
        first->segments.insert(first->segments.end(), second->segments.begin(),
                               second->segments.end());
    return same;
}

}  // namespace

std::span<const WordRow> shape_words() {
    static constexpr auto kWords = word_rows("Shape", kRows);
    return kWords;
}

std::optional<ShapeDescription> shape_of(const Statement& statement, Reading& reading) {
    const Row& row = row_of(statement);
    reading.log.count_word(statement.keyword, statement.type);
    const GraphicsState& state = reading.state;
    ShapeDescription shape;
    LocalShape made = row.maker(statement, reading);
    shape.placed = {std::move(made.shape),
                    translation(made.origin) * reading.still_matrix(statement.where),
                    state.reverse_orientation};
    shape.emission = emission_here(statement, shape.placed.shape, reading);
    if (!shape.emission && turns_where_mirrored(shape.placed))
        shape.placed.flip = !shape.placed.flip;
    shape.where = statement.where;
    shape.name = shape_name(statement);
    const bool is_there = take_alpha(statement, reading, shape);
    reading.log.warn_unused(statement);
    if (!is_there) return std::nullopt;
    return shape;
}

void place_shape(ShapeDescription shape, Reading& reading) {
    const GraphicsState& state = reading.state;
    shape.material = state.material;
    shape.media = {reading.media.number_of(state.inside_medium, shape.where),
                   reading.media.number_of(state.outside_medium, shape.where)};
    reading.materials.use(shape.material);
    auto& scene = reading.scene;
    auto& list = reading.open_object ? scene.objects[*reading.open_object] : scene.shapes;
    if (!list.empty() && joined(list.back(), shape)) return;
    list.push_back(std::move(shape));
}

void add_shape(const Statement& statement, Reading& reading) {
    if (auto shape = shape_of(statement, reading)) place_shape(std::move(*shape), reading);
}

}  // namespace sunfleck::engine
