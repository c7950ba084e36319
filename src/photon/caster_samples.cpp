// Points on casters, with a light sample at each.
#include "photon/caster_samples.h"

#include "core/parallel.h"
#include "geometry/affine.h"
#include "geometry/measure.h"
#include "light/emitting_surface.h"
#include "photon/initial_guide_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sunfleck::engine {
namespace {

/// Returns whether some surface of the material is smooth or glossy.
bool may_bend_light(const Scene& scene, const Material& material) {
    if (const auto* mix = std::get_if<MixMaterial>(&material))
        return std::any_of(mix->components.begin(), mix->components.end(), [&](std::uint32_t m) {
            return may_bend_light(scene, scene.materials()[m]);
        });
    return !std::holds_alternative<DiffuseMaterial>(material) &&
           !std::holds_alternative<DiffuseTransmissionMaterial>(material) &&
           !std::holds_alternative<InterfaceMaterial>(material);
}

/// The shapes of casters, with all instances. Curves are none: hardly any light that they reflect
/// is gathered.
class Casters {
public:
    explicit Casters(const Scene& scene) : scene_(scene) {
        const GeometryInput& input = scene.geometry().input();
        input.for_each_placed([&](std::uint32_t shape, const Matrix& outer) {
            add(shape, input.shapes[shape], outer);
        });
    }

    bool empty() const { return casters_.empty(); }

    /// A point, whose `spread` is one over the density of points there.
    SurfaceSample sample(RandomStream& stream) const {
        const auto count = static_cast<double>(casters_.size());
        const double area = casters_.back().end;
        // Half of the samples by area, half evenly over the shapes: a stone beside a shop window.
        const bool by_area = stream.next() < 0.5;
        const double which = stream.next();
        const Caster& caster =
            by_area ? *std::upper_bound(casters_.begin(), casters_.end() - 1, which * area,
                                        [](double at, const Caster& c) { return at < c.end; })
                    : casters_[static_cast<std::size_t>(which * count)];
        const auto element = static_cast<std::uint32_t>(
            stream.next() * static_cast<double>(elements_of(caster.placed->shape)));
        const double u = stream.next();
        SurfaceSample at = on(caster, element, {u, stream.next()});
        const double chance = 0.5 * caster.area / area + 0.5 / count;
        at.spread *= static_cast<double>(elements_of(caster.placed->shape)) / chance;
        return at;
    }

private:
    struct Caster {
        const PlacedShape* placed;
        Matrix to_world;
        double area = 0;
        double end = 0;  // of all areas so far
    };

    void add(std::uint32_t shape, const PlacedShape& placed, const Matrix& outer) {
        Hit hit;
        hit.shape = shape;
        if (!may_bend_light(scene_, scene_.materials()[scene_.material_of(hit)])) return;
        if (elements_of(placed.shape) == 0) return;
        const double area = area_of(shape, placed, Affine(outer));
        if (!(area > 0) || !std::isfinite(area)) return;
        const double before = casters_.empty() ? 0 : casters_.back().end;
        casters_.push_back({&placed, placed.to_world * outer, area, before + area});
    }

    static std::size_t elements_of(const Shape& shape) {
        if (const auto* mesh = std::get_if<TriangleMesh>(&shape)) return mesh->triangles.size();
        if (const auto* mesh = std::get_if<BilinearMesh>(&shape)) return mesh->patches.size();
        return std::holds_alternative<Curves>(shape) ? 0 : 1;
    }

    /// Approximate in instances that are stretched: it only decides how often a shape is looked at.
    double area_of(std::uint32_t number, const PlacedShape& placed, const Affine& outer) {
        const auto [known, is_new] = areas_.try_emplace(number, 0);
        if (is_new) known->second = surface_area(placed);
        const double scale = std::cbrt(static_cast<float>(std::abs(outer.determinant())));
        return known->second * scale * scale;
    }

    static SurfaceSample on(const Caster& caster, std::uint32_t element, const Vec2d& u) {
        return std::visit([&](const auto& s) { return on(s, caster, element, u); },
                          caster.placed->shape);
    }
    /// Nowhere for a triangle with an invalid index, which is not in the geometry.
    static SurfaceSample on(const TriangleMesh& mesh, const Caster& caster, std::uint32_t element,
                            const Vec2d& u) {
        const auto& corners = mesh.triangles[element];
        if (*std::max_element(corners.begin(), corners.end()) >= mesh.positions.size())
            return {Vec3d(std::numeric_limits<double>::quiet_NaN()), Vec3d(0)};
        const Triangle t = placed_triangle(mesh, Affine(caster.to_world), element);
        return sample_surface(
            EmittingTriangle{t.corner[0], t.corner[1] - t.corner[0], t.corner[2] - t.corner[0],
                             t.area_vector().normalized()},
            u);
    }
    static SurfaceSample on(const BilinearMesh& mesh, const Caster& caster, std::uint32_t element,
                            const Vec2d& u) {
        const Affine to_world(caster.to_world);
        EmittingPatch patch{mesh.element(element).surface};
        for (Vec3d& corner : patch.surface.corner) corner = to_world.point(corner);
        return sample_surface(patch, u);
    }
    static SurfaceSample on(const Curves&, const Caster&, std::uint32_t, const Vec2d&) {
        return {};
    }
    template <class Quadric>
    static SurfaceSample on(const Quadric& quadric, const Caster& caster, std::uint32_t,
                            const Vec2d& u) {
        return sample_surface(EmittingQuadric<Quadric>{quadric, caster.to_world}, u);
    }

    const Scene& scene_;
    std::vector<Caster> casters_;
    std::map<std::uint32_t, double> areas_;  // of shapes, outside of any instance
};

}  // namespace

std::vector<WeightedEmission> caster_samples(const PassScene& scene, const LightChoice& lights,
                                             PassId pass, const PathRange& tries) {
    constexpr std::size_t kBlock = 1024;
    const Casters casters(scene.scene);
    if (casters.empty() || lights.empty()) return {};
    const InitialGuideSamples guide_samples(scene, lights);
    std::vector<std::vector<WeightedEmission>> blocks((tries.size() + kBlock - 1) / kBlock);
    parallel_blocks(tries.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            RandomStream stream = pass.stream(Purpose::caster, tries.begin + i);
            const SurfaceSample at = casters.sample(stream);
            const Vec3 position(at.position);
            if (!std::isfinite(position.x + position.y + position.z)) continue;
            const auto light = guide_samples.sample(position, stream);
            if (!light) continue;
            const double facing = std::abs(at.normal.dot(Vec3d(light->direct.direction)));
            const double flux = at.spread * facing / light->probability *
                                double{light->direct.factor} *
                                double{guide_samples.emitted_by(light->light).sum()};
            if (const auto found = guide_samples.guide_sample(*light, position, flux, stream))
                blocks[begin / kBlock].push_back(*found);
        }
    });
    std::vector<WeightedEmission> all;
    for (const auto& block : blocks) all.insert(all.end(), block.begin(), block.end());
    return all;
}

}  // namespace sunfleck::engine
