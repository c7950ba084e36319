// Steps of the walks, and their records and votes.
#include "scene/media_walks.h"

#include "core/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kWalks = 2048;  // from the camera, and from all lights of a group together
constexpr int kMostSteps = 24;
constexpr int kMostCrossings = 64;
constexpr std::uint64_t kRandomKey = 0x6D656469615F6973;  // unlike a seed

/// Samples a uniform direction on a side of a surface.
Vec3 direction_above(const Vec3& normal, const Vec2d& numbers) {
    const double z = 1 - 2 * numbers.x;
    const double size = std::sqrt(std::max(0.0, 1 - z * z));
    const double angle = 2 * std::numbers::pi * numbers.y;
    const Vec3 any(Vec3d(size * std::cos(angle), size * std::sin(angle), z));
    return any.dot(normal) < 0 ? -any : any;
}

/// Returns whether the normal of a closed shape points into it: a ray along it leaves the shape one
/// time more than it enters.
bool normal_points_in(const Geometry& geometry, const Hit& start) {
    int crossings = 0;
    Ray ray = ray_from(start, start.normal);
    for (int i = 0; i < kMostCrossings; ++i) {
        const auto hit = geometry.intersect(ray);
        if (!hit) break;
        if (hit->shape == start.shape) ++crossings;
        ray = ray_from(*hit, start.normal);
    }
    return crossings % 2 == 1;
}

/// Returns the medium of a walk at the end of a ray; nothing if the ray is blocked.
std::optional<MediumNumber> medium_at_end(const Surfaces& surfaces,
                                          const std::set<std::uint32_t>& ends, Ray ray,
                                          MediumNumber medium) {
    for (int i = 0; i < kMostCrossings; ++i) {
        const auto hit = surfaces.geometry().intersect(ray);
        if (!hit) return medium;
        if (!surfaces.lets_light_through(*hit) || ends.contains(hit->shape)) return {};
        if (surfaces.medium_beyond(*hit, -ray.direction, medium) != medium) return {};
        medium = surfaces.medium_beyond(*hit, ray.direction, medium);
        const float left = ray.length - hit->distance;
        if (!(left > 0)) return medium;
        ray = ray_from(*hit, ray.direction);
        ray.length = left;
    }
    return {};
}

/// Returns direction and distance to a position.
std::optional<DirectSample> sample_towards(const Vec3& position, const Vec3& from) {
    const Vec3 offset = position - from;
    const float distance = offset.length();
    if (!(distance > 0)) return {};
    DirectSample sample;
    sample.direction = offset * (1 / distance);
    sample.distance = distance;
    return sample;
}

/// @param first  the first light of the source.
MediaStart start_at(const LightRange& source, const Light& first, const Surfaces& surfaces,
                    const Media& stated) {
    MediaStart start{source, stated.at_lights[source.first]};
    const auto* area = std::get_if<AreaLight>(&first);
    if (area != nullptr && area->shape != kNone && surfaces.media_of(area->shape).differ())
        start.sides = surfaces.media_of(area->shape);  // they may have been exchanged
    start.is_named = start.sides != MediumSides{};
    return start;
}

MediumNumber most_heard(const std::map<MediumNumber, int>& heard) {
    return std::max_element(heard.begin(), heard.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

}  // namespace

Vec2d MediaWalks::next_two() {
    const RandomBlock words = philox({drawn_++, 0, 0, 0}, kRandomKey);
    const auto unit = [&](std::size_t i) {
        return to_unit(std::uint64_t{words.at(i)} << 32U | words.at(i + 1));
    };
    return {unit(0), unit(2)};
}

MediaWalks::MediaWalks(const Surfaces& surfaces, const PathOrigins& origins, const Media& stated,
                       const std::set<std::uint32_t>& ends)
    : surfaces_(surfaces), origins_(origins), ends_(ends) {
    const MediumNumber at_camera = stated.at_camera;
    starts_.push_back({{}, {at_camera, at_camera}, at_camera != 0});
    const SceneLights& lights = origins.lights;
    for (const LightRange& source : lights.sources()) {
        const Light& light = lights.all()[source.first];
        if (comes_from_afar(light) || std::holds_alternative<MediumLight>(light)) continue;
        if (power(light, lights.sphere()) > 0)
            starts_.push_back(start_at(source, light, surfaces, stated));
    }
}

void MediaWalks::walk_all() {
    std::vector<std::size_t> named;
    std::vector<std::size_t> unnamed;
    for (std::size_t i = 1; i < starts_.size(); ++i)
        (starts_[i].is_named ? named : unnamed).push_back(i);
    const auto take_heard = [this](std::size_t start) {
        auto& [lights, sides, is_named, heard, wrong] = starts_[start];
        if (!is_named && !heard.empty()) sides = {most_heard(heard), most_heard(heard)};
    };
    if (starts_[0].is_named) walk_from({0});
    walk_from(named);
    take_heard(0);
    if (!starts_[0].is_named) walk_from({0});
    for (const std::size_t start : unnamed) take_heard(start);
    walk_from(unnamed);
}

void MediaWalks::walk_from(const std::vector<std::size_t>& starts) {
    if (starts.empty()) return;
    for (std::size_t i = 0; i < kWalks; ++i) {
        const MediaStart& start = starts_[starts[i * starts.size() / kWalks]];
        if (start.lights.count == 0)
            walk(camera_walk(), start.is_named);
        else if (const auto first = light_walk(start, i))
            walk(*first, start.is_named);
    }
}

MediaWalks::Walk MediaWalks::camera_walk() {
    const CameraRay ray = origins_.camera.ray_at(next_two());
    return {{Vec3(ray.origin), Vec3(ray.direction)}, starts_[0].sides.outside};
}

std::optional<MediaWalks::Walk> MediaWalks::light_walk(const MediaStart& start, std::size_t i) {
    const Light& light = origins_.lights.all()[start.lights.first + i % start.lights.count];
    const Vec2d position = next_two();
    const Vec2d direction_numbers = next_two();
    const Emission first =
        sample_emission(light, {position.x, position.y, direction_numbers.x, direction_numbers.y},
                        origins_.lights.sphere());
    if (!(first.factor > 0)) return {};
    const Vec3 direction(first.direction);
    return Walk{
        {offset_origin(Vec3(first.origin), first.normal, first.error, direction), direction},
        start.sides.towards(first.normal, direction)};
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): it moves on
void MediaWalks::walk(Walk at, bool is_named) {
    auto& [ray, medium] = at;
    look_around(nullptr, ray, medium);
    for (int i = 0; i < kMostSteps; ++i) {
        const auto hit = surfaces_.geometry().intersect(ray);
        if (!hit || ends_.contains(hit->shape)) return;
        if (!agrees(*hit, at, is_named)) return;
        if (surfaces_.lets_light_through(*hit)) {
            medium = surfaces_.medium_beyond(*hit, ray.direction, medium);
            ray = ray_from(*hit, ray.direction);
        } else {
            const bool above = hit->normal.dot(ray.direction) < 0;
            ray = ray_from(*hit, direction_above(above ? hit->normal : -hit->normal, next_two()));
            look_around(&*hit, ray, medium);
        }
    }
}

/// Returns whether the surface names the medium of the walk, or none at all.
bool MediaWalks::agrees(const Hit& hit, const Walk& at, bool is_named) {
    if (!surfaces_.separates_media(hit)) return true;
    ShapeVotes& of_shape = votes_[hit.shape];
    MediaVotes& votes = is_named ? of_shape.named : of_shape.assumed;
    const bool right = surfaces_.medium_beyond(hit, -at.ray.direction, at.medium) == at.medium;
    const bool exchanged = surfaces_.medium_beyond(hit, at.ray.direction, at.medium) == at.medium;
    if (right)
        ++votes.right;
    else if (exchanged && normal_points_in(surfaces_.geometry(), hit))
        ++votes.inside_out;
    else
        ++votes.other;
    return right;
}

/// Tests the visibility of one start, each in turn.
/// @param hit  position of the walk, or null at its start.
/// @param ray  its next ray.
void MediaWalks::look_around(const Hit* hit, const Ray& ray, MediumNumber medium) {
    MediaStart& start = starts_[next_looked_at_++ % starts_.size()];
    const auto& [first, count] = start.lights;
    const auto sample = count == 0
                            ? sample_towards(Vec3(origins_.camera.middle_ray().origin), ray.origin)
                            : sample_direct(origins_.lights.all()[first + next_looked_at_ % count],
                                            ray.origin, Vec2(next_two()), origins_.lights.sphere());
    if (!sample || !(sample->distance > 0) || !std::isfinite(sample->distance)) return;
    const auto is_above = [&](const Vec3& direction) { return hit->normal.dot(direction) > 0; };
    if (hit != nullptr && is_above(sample->direction) != is_above(ray.direction)) return;
    const Ray look = hit != nullptr
                         ? shadow_ray(*hit, sample->direction, sample->distance)
                         : Ray{ray.origin, sample->direction, sample->distance * (1 - 1e-4F)};
    const auto found = medium_at_end(surfaces_, ends_, look, medium);
    if (!found) return;
    ++start.heard[*found];
    if (*found != start.sides.towards(sample->normal, -sample->direction)) ++start.wrong;
}

}  // namespace sunfleck::engine
