// Triangles in groups of one material, each a mesh with vertices of its own.
#include "import/part/shapes.h"

#include "geometry/closed_surface.h"
#include "geometry/middle.h"
#include "geometry/weld.h"
#include "image/srgb.h"
#include "import/part/names.h"
#include "scene/absorption.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace sunfleck::engine {
namespace {

/// What the triangles of a shape have in common.
struct GroupKey {
    std::uint32_t material = kNoIndex;
    bool has_normals = false;
    bool is_closed = false;  // of glass and light alone

    friend bool operator<(const GroupKey& a, const GroupKey& b) {
        return std::tie(a.material, a.has_normals, a.is_closed) <
               std::tie(b.material, b.has_normals, b.is_closed);
    }
};

/// Makes one vertex of each different corner.
class VertexMaker {
public:
    /// @param positions  of the part, rounded.
    VertexMaker(const ObjMesh& mesh, const std::vector<Vec3>& positions)
        : mesh_(mesh), positions_(positions), first_(positions.size(), kNoIndex) {}

    struct Corner {
        std::uint32_t position = 0;
        std::uint32_t uv = kNoIndex;
        std::uint32_t normal = kNoIndex;
        bool is_turned = false;  // its normal points to the other side
    };

    void begin(bool has_normals) {
        for (const Vertex& vertex : vertices_) first_[vertex.corner.position] = kNoIndex;
        vertices_.clear();
        made_ = {};
        colours_ = {};
        has_normals_ = has_normals;
    }

    std::uint32_t vertex_of(const Corner& corner) {
        std::uint32_t& first = first_[corner.position];
        for (std::uint32_t i = first; i != kNoIndex; i = vertices_[i].next)
            if (is_same(vertices_[i].corner, corner)) return i;
        vertices_.push_back({corner, first});
        add(corner);
        return first = static_cast<std::uint32_t>(vertices_.size() - 1);
    }

    void add_triangle(const std::array<std::uint32_t, 3>& triangle) {
        made_.triangles.push_back(triangle);
    }
    TriangleMesh finished() { return std::move(made_); }
    /// Returns linear RGB of the vertices, if the part has colours.
    std::vector<Vec3> colours() { return std::move(colours_); }

private:
    struct Vertex {
        Corner corner;
        std::uint32_t next = kNoIndex;  // at the same position
    };

    static bool is_same(const Corner& a, const Corner& b) {
        return a.uv == b.uv && a.normal == b.normal && a.is_turned == b.is_turned;
    }

    void add(const Corner& corner) {
        made_.positions.push_back(positions_[corner.position]);
        if (has_normals_) {
            const Vec3& normal = mesh_.normals[corner.normal];
            made_.normals.push_back(corner.is_turned ? -normal : normal);
        }
        if (!mesh_.uv_corners.empty())
            made_.uvs.push_back(corner.uv == kNoIndex ? Vec2(0) : mesh_.uvs[corner.uv]);
        if (mesh_.colours.empty()) return;
        const Vec3& colour = mesh_.colours[corner.position];
        colours_.emplace_back(srgb_decode(colour.x), srgb_decode(colour.y), srgb_decode(colour.z));
    }

    const ObjMesh& mesh_;
    const std::vector<Vec3>& positions_;
    std::vector<std::uint32_t> first_;  // vertex by position
    std::vector<Vertex> vertices_;
    TriangleMesh made_;
    std::vector<Vec3> colours_;
    bool has_normals_ = false;
};

class ShapeMaker {
public:
    using LookOf = std::function<const PartLook&(std::uint32_t)>;

    ShapeMaker(SceneDescription& scene, ObjMesh mesh, const PartPlacement& placement,
               const LookOf& look_of)
        : scene_(scene),
          mesh_(std::move(mesh)),
          objects_(mesh_, scene.path),
          placement_(placement),
          look_of_(look_of) {}

    void run() {
        round_positions();
        find_sides();
        std::map<GroupKey, std::vector<std::uint32_t>> groups;
        for (std::size_t r = 0; r < mesh_.runs.size(); ++r) {
            const std::size_t end =
                r + 1 < mesh_.runs.size() ? mesh_.runs[r + 1].first : mesh_.triangles.size();
            for (std::size_t t = mesh_.runs[r].first; t < end; ++t)
                if (!is_flat(t))
                    groups[key_of(t, mesh_.runs[r].material)].push_back(
                        static_cast<std::uint32_t>(t));
        }
        VertexMaker maker(mesh_, positions_);
        for (const auto& [key, triangles] : groups) {
            TriangleMesh mesh = mesh_of(maker, key, triangles);
            add_shape(key, std::move(mesh), maker.colours());
            objects_.name(scene_.shapes.back(), triangles);
        }
    }

private:
    void round_positions() {
        std::vector<Bounds> boxes;
        Bounds all;
        for (const ObjTriangle& t : mesh_.triangles)
            for (const std::uint32_t corner : t) all.extend(mesh_.positions[corner]);
        boxes.push_back(all);
        origin_ = origin_near(middle_of(boxes));
        positions_.reserve(mesh_.positions.size());
        for (const Vec3d& p : mesh_.positions) positions_.emplace_back(p - origin_);
        mesh_.positions = {};
    }

    bool needs_sides(std::uint32_t material) const {
        const PartLook& look = look_of_(material);
        return look.glass || look.emission;
    }

    void find_sides() {
        const bool needed =
            std::any_of(mesh_.runs.begin(), mesh_.runs.end(),
                        [&](const ObjRun& run) { return needs_sides(run.material); });
        if (!needed) return;
        Welder welder;
        std::vector<std::uint32_t> numbers(positions_.size(), kNoIndex);
        std::vector<ObjTriangle> welded = mesh_.triangles;
        for (ObjTriangle& t : welded)
            for (std::uint32_t& corner : t) {
                std::uint32_t& number = numbers[corner];
                if (number == kNoIndex) number = welder.number_of(positions_[corner]);
                corner = number;
            }
        sides_ = sides_of(welder.positions(), welded);
        flat_.reserve(welded.size());
        for (const ObjTriangle& t : welded)
            flat_.push_back(t[0] == t[1] || t[1] == t[2] || t[2] == t[0]);
    }

    /// Returns whether two corners of a triangle are at one place, where that is known.
    bool is_flat(std::size_t t) const { return !flat_.empty() && flat_[t]; }

    GroupKey key_of(std::size_t t, std::uint32_t material) const {
        GroupKey key;
        key.material = material;
        key.has_normals = !mesh_.normal_corners.empty() && mesh_.normal_corners[t][0] != kNoIndex;
        key.is_closed = !sides_.is_closed.empty() && sides_.is_closed[t] && needs_sides(material);
        return key;
    }

    VertexMaker::Corner corner_of(std::size_t t, std::size_t k, bool has_normals) const {
        VertexMaker::Corner corner;
        corner.position = mesh_.triangles[t].at(k);
        if (!mesh_.uv_corners.empty()) corner.uv = mesh_.uv_corners[t].at(k);
        if (has_normals) corner.normal = mesh_.normal_corners[t].at(k);
        return corner;
    }

    /// Returns whether the normals of a triangle point to its back.
    bool are_turned(const std::array<VertexMaker::Corner, 3>& c) const {
        const Vec3d a(positions_[c[0].position]);
        const Vec3d area =
            (Vec3d(positions_[c[1].position]) - a).cross(Vec3d(positions_[c[2].position]) - a);
        const Vec3 sum =
            mesh_.normals[c[0].normal] + mesh_.normals[c[1].normal] + mesh_.normals[c[2].normal];
        return area.dot(Vec3d(sum)) < 0;
    }

    TriangleMesh mesh_of(VertexMaker& maker, const GroupKey& key,
                         const std::vector<std::uint32_t>& triangles) const {
        maker.begin(key.has_normals);
        for (const std::uint32_t t : triangles) {
            std::array<VertexMaker::Corner, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) corners.at(k) = corner_of(t, k, key.has_normals);
            if (key.is_closed) {
                if (sides_.is_reversed[t]) std::swap(corners[1], corners[2]);
                const bool turned = key.has_normals && are_turned(corners);
                for (VertexMaker::Corner& corner : corners) corner.is_turned = turned;
            }
            maker.add_triangle({maker.vertex_of(corners[0]), maker.vertex_of(corners[1]),
                                maker.vertex_of(corners[2])});
        }
        return maker.finished();
    }

    std::uint32_t material_of_colours(const TriangleMesh& mesh, std::vector<Vec3> colours) {
        VertexColourKind kind;
        kind.colours = {std::make_shared<const VertexValues<Vec3>::Triangles>(mesh.triangles),
                        std::make_shared<const std::vector<Vec3>>(std::move(colours))};
        const std::uint32_t material =
            add_material(scene_, DiffuseMaterial{SpectrumTexture(SpectrumKind{std::move(kind)})});
        name_material(scene_, material, "colours of vertices");
        return material;
    }

    void add_shape(const GroupKey& key, TriangleMesh mesh, std::vector<Vec3> colours) {
        const PartLook& look = look_of_(key.material);
        ShapeDescription shape;
        shape.material = look.takes_vertex_colours ? material_of_colours(mesh, std::move(colours))
                                                   : look.material;
        shape.emission = look.emission;
        if (shape.emission) shape.emission->two_sided = !key.is_closed;
        shape.placed.cover = look.cover;
        shape.alpha = look.alpha;
        shape.where = {scene_.path};
        if (look.glass) set_glass(key, *look.glass, mesh, shape);
        const double scale = placement_.metres_per_unit;
        Matrix& m = shape.placed.to_world;
        for (int c = 0; c < 3; ++c) {
            m[c][c] = scale;
            m[3][c] = origin_[c] * scale;
        }
        shape.placed.shape = std::move(mesh);
        scene_.shapes.push_back(std::move(shape));
    }

    void set_glass(const GroupKey& key, const PartLook::Glass& glass, const TriangleMesh& mesh,
                   ShapeDescription& shape) {
        const bool is_solid = placement_.glass == GlassRule::automatic
                                  ? key.is_closed
                                  : placement_.glass == GlassRule::solid;
        if (!is_solid) {
            shape.material = glass.pane;
            if (placement_.glass == GlassRule::automatic)
                scene_.warnings.add({scene_.path},
                                    "glass whose surface is open is a thin pane (--glass)");
            return;
        }
        shape.media.inside = glass.medium;
        const double chord =
            placement_.metres_per_unit * mean_chord_of(mesh.positions, mesh.triangles);
        if (glass.filter == Vec3d(1) || !(chord > 0)) return;
        shape.media.inside =
            add_medium(scene_, Spectrum::rgb_unbounded(Vec3(absorption_over(chord, glass.filter))));
    }

    SceneDescription& scene_;
    ObjMesh mesh_;
    PartObjects objects_;
    PartPlacement placement_;
    const LookOf& look_of_;
    Vec3d origin_{0};              // of the positions
    std::vector<Vec3> positions_;  // rounded
    SurfaceSides sides_;           // empty where no material needs them
    std::vector<bool> flat_;       // likewise
};

}  // namespace

void add_part_shapes(SceneDescription& scene, ObjMesh mesh, const PartPlacement& placement,
                     const std::function<const PartLook&(std::uint32_t)>& look_of) {
    ShapeMaker(scene, std::move(mesh), placement, look_of).run();
}

}  // namespace sunfleck::engine
