// Walks, and who names what on their way.
#include "scene/media_check.h"

#include "scene/outer_medium.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace sunfleck {
namespace {

constexpr int kWalks = 2048;
constexpr int kMostSteps = 24;
constexpr int kMostCrossings = 64;

/// Numbers that fill [0, 1) evenly: multiples of 1/g and 1/g^2, g^3 = g + 1.
class EvenNumbers {
public:
    Vec2d next() {
        at_ = {std::fmod(at_.x + 0.7548776662466927, 1.0),
               std::fmod(at_.y + 0.5698402909980532, 1.0)};
        return at_;
    }

private:
    Vec2d at_{0.5, 0.5};
};

/// Shapes stand in each other: those within are looked at when those around them are right.
constexpr int kMostNested = 16;

/// Shapes, by their number in the scene, ascending.
struct MediaFaults {
    std::vector<std::uint32_t> inside_out;  // closed, normals inwards; right if exchanged
    std::vector<std::uint32_t> at_odds;     // the others that name a medium that is not there
};

/// What walks have met at a shape.
struct Votes {
    int right = 0;
    int inside_out = 0;
    int other = 0;
};

/// A direction on that side of a surface, any as likely as any other.
Vec3 direction_above(const Vec3& normal, const Vec2d& numbers) {
    const double z = 1 - 2 * numbers.x;
    const double size = std::sqrt(std::max(0.0, 1 - z * z));
    const double angle = 2 * std::numbers::pi * numbers.y;
    const Vec3 any(Vec3d(size * std::cos(angle), size * std::sin(angle), z));
    return any.dot(normal) < 0 ? -any : any;
}

/// Does the normal of a closed shape point into what it encloses? A ray that starts there leaves
/// the shape one time more than it enters it.
bool normal_points_in(const Scene& scene, const Hit& start) {
    int crossings = 0;
    Ray ray = ray_from(start, start.normal);
    for (int i = 0; i < kMostCrossings; ++i) {
        const auto hit = scene.geometry().intersect(ray);
        if (!hit) break;
        if (hit->shape == start.shape) ++crossings;
        ray = ray_from(*hit, start.normal);
    }
    return crossings % 2 == 1;
}

/// Each walk ends at the first shape that does not name the medium through which the walk came.
class Walker {
public:
    explicit Walker(const Scene& scene) : scene_(scene) {}

    void walk() {
        const Vec2d place = Vec2d(scene_.film().resolution) * numbers_.next();
        const CameraRay view = camera_ray(scene_.camera(), place, {0.5, 0.5});
        Ray ray{Vec3(view.origin), Vec3(view.direction)};
        MediumNumber medium = scene_.media().at_camera;
        for (int i = 0; i < kMostSteps; ++i) {
            const auto hit = scene_.geometry().intersect(ray);
            if (!hit || !agrees(*hit, ray.direction, medium)) return;
            if (can_be_passed(scene_, *hit)) {
                medium = scene_.medium_beyond(*hit, ray.direction, medium);
                ray = ray_from(*hit, ray.direction);
            } else {
                const bool above = hit->normal.dot(ray.direction) < 0;
                ray = ray_from(
                    *hit, direction_above(above ? hit->normal : -hit->normal, numbers_.next()));
            }
        }
    }

    MediaFaults faults() const {
        MediaFaults result;
        for (const auto& [shape, votes] : votes_) {
            if (votes.inside_out > votes.right + votes.other)
                result.inside_out.push_back(shape);
            else if (votes.inside_out + votes.other > votes.right)
                result.at_odds.push_back(shape);
        }
        return result;
    }

private:
    /// Does the surface name the medium from which the walk comes, or none at all?
    bool agrees(const Hit& hit, const Vec3& direction, MediumNumber medium) {
        if (!scene_.parts_media(hit)) return true;
        Votes& votes = votes_[hit.shape];
        const bool right = scene_.medium_beyond(hit, -direction, medium) == medium;
        const bool exchanged = scene_.medium_beyond(hit, direction, medium) == medium;
        if (right)
            ++votes.right;
        else if (exchanged && normal_points_in(scene_, hit))
            ++votes.inside_out;
        else
            ++votes.other;
        return right;
    }

    const Scene& scene_;
    EvenNumbers numbers_;
    std::map<std::uint32_t, Votes> votes_;  // by shape
};

MediaFaults media_faults(const Scene& scene) {
    Walker walker(scene);
    for (int i = 0; i < kWalks; ++i) walker.walk();
    return walker.faults();
}

}  // namespace

void mend_media(const Scene& scene, const std::vector<SourceLocation>& places,
                std::vector<ShapeRecord>& shapes, Warnings& warnings) {
    MediaFaults faults = media_faults(scene);
    for (int i = 0; i < kMostNested && !faults.inside_out.empty(); ++i) {
        for (const std::uint32_t shape : faults.inside_out) {
            std::swap(shapes[shape].media.inside, shapes[shape].media.outside);
            warnings.add(places[shape],
                         "the normals of this shape point into it, so that its MediumInterface "
                         "names the medium within as the one around it; the two are exchanged; "
                         "leave out ReverseOrientation, or turn its triangles (glass refracts by "
                         "these normals, too), or write the media in the other order");
        }
        faults = media_faults(scene);
    }
    for (const std::uint32_t shape : faults.at_odds)
        warnings.add(places[shape],
                     "its MediumInterface does not name the medium through which it is seen, so "
                     "that light and camera paths may cross different media; name the same medium "
                     "for the sides of surfaces, and the camera, that face each other");
}

}  // namespace sunfleck
