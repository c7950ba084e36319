// The light of media along a camera path: single scattering by light samples, and visible points,
// which gather what photons bring (docs/method/media.md).
//
// A ray through a medium that scatters is looked at where it might be scattered: at one distance,
// drawn by the free path. Light is sampled there, and photons count that are scattered in a piece
// of the ray around it. The path itself goes on to the surface, with what the medium leaves of it.
#include "camera_paths/camera_path.h"
#include "camera_paths/medium_tuning.h"
#include "medium/equiangular.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns a point on a lamp that is not far away; nothing if none is chosen.
std::optional<Vec3> lamp_near(const PassScene& pass, const Vec3& place, BatchPoints& numbers) {
    const double choice = numbers.next();
    const Vec2 u(numbers.next_2d());
    const auto chosen = pass.scene.light_tree().choose({place, Vec3(0)}, choice);
    if (!chosen) return {};
    const Light& light = pass.scene.lights()[chosen->index];
    if (comes_from_afar(light)) return {};
    const auto sample = sample_direct(light, place, u, pass.scene.sphere());
    if (!sample || !(sample->distance < kInfinity)) return {};
    return place + sample->direction * sample->distance;
}

/// Returns the length over which the middle half of the light is scattered: of a cloud far from the
/// eye, the distance says nothing.
float middle_half(const FreeWay& path) {
    return path.distance_at(0.75F * path.chance()) - path.distance_at(0.25F * path.chance());
}

/// Which piece of a way photons are gathered in, by one number.
class PieceChoice {
public:
    /// @param path  must outlive this. Where the density varies, half of the pieces are drawn
    /// evenly from where it begins to where it ends: photons beside the ray may be where hardly
    /// anything is on it.
    PieceChoice(const FreeWay& path, bool varies)
        : path_(path),
          first_(varies ? path.distance_at(0) : 0),
          last_(varies ? path.distance_at(path.chance()) : 0) {}

    /// Returns a distance in the piece. @param u  in [0,1).
    float distance(float u) const {
        if (!is_even()) return path_.distance_at(path_.chance() * u);
        if (u < 0.5F) return path_.distance_at(path_.chance() * 2 * u);
        return first_ + (last_ - first_) * (2 * u - 1);
    }
    /// Returns the chance of a piece.
    float chance(float begin, float end) const {
        const float by_path = path_.chance_between(begin, end) / path_.chance();
        if (!is_even()) return by_path;
        const float length = std::min(end, last_) - std::max(begin, first_);
        return (by_path + std::max(0.0F, length) / (last_ - first_)) / 2;
    }

private:
    bool is_even() const { return last_ > first_; }

    const FreeWay& path_;
    float first_;
    float last_;
};

/// Returns the radius for indirect light over the other one. @param scale  a length.
float widening(float radius, float scale) {
    return std::clamp(kPartOfScale * scale / radius, 1.0F, kMostWidening);
}

}  // namespace

/// Returns the vertex of the path at a point of its medium. @param phase  must outlive it.
CameraVertex CameraPath::vertex_in_medium(const Vec3& position, const Bsdf& phase) const {
    const Hit here = point_in_medium(position);
    return {here, Frame(here.normal), -direction_, phase, medium_, pass_.settings.ris};
}

/// @param hit  what the ray hits, if anything; the next one if the path is scattered.
CameraPath::Crossing CameraPath::cross_medium(std::optional<Hit>& hit, BatchPoints& numbers) {
    const SampledMedium& medium = pass_.scene.media[medium_];
    const Ray way{from_, direction_, hit ? hit->distance : kInfinity};
    if (medium.glow != nullptr) add_glow(medium, way, numbers);
    if (medium.scatters) {
        if (beyond_) return fly_beyond(medium, way, hit, numbers);
        if (bounces_ < pass_.transport.max_depth)
            CameraPath(*this).look_into(medium, way, numbers.branch());
    }
    const SampledSpectrum left = transmittance(medium, way);
    throughput_ *= left;
    media_left_ *= left;
    return Crossing::passed;
}

/// Adds what media leave of white light from the first surface, or from afar.
void CameraPath::add_transmittance() {
    if (!image_.has(Aov::transmittance)) return;
    const PassScene& scene = pass_.scene;
    image_.add_feature(pixel_, scene.wavelengths.to_rgb(media_left_ * scene.white) * of_pixel_,
                       Aov::transmittance);
}

/// After the first vertex that gathers, a path is scattered or passes.
CameraPath::Crossing CameraPath::fly_beyond(const SampledMedium& medium, const Ray& way,
                                            std::optional<Hit>& hit, BatchPoints& numbers) {
    const Flight flight = fly(medium, way, throughput_, static_cast<float>(numbers.next()));
    throughput_ *= flight.weight;
    if (!flight.is_scattered) return Crossing::passed;
    if (bounces_ >= pass_.transport.max_depth) return Crossing::ended;
    grow_footprint(flight.distance);
    const Bsdf phase = medium.phase;
    const CameraVertex vertex = vertex_in_medium(way.origin + direction_ * flight.distance, phase);
    add_direct_light(vertex, numbers, false);
    if (!scatter(vertex, numbers)) return Crossing::ended;
    hit = pass_.scene.scene.geometry().intersect(ray_beyond(vertex.hit));
    return Crossing::scattered;
}

/// Adds the light that the medium scatters towards the camera; this path ends there.
void CameraPath::look_into(const SampledMedium& medium, const Ray& way, BatchPoints numbers) {
    const FreeWay path(medium, way, throughput_);
    const float chance = path.chance();
    if (!(chance > 0)) return;
    has_features_ = true;
    const Vec2d draws = numbers.next_2d();
    const float here = path.distance_at(chance * static_cast<float>(draws.x));
    // Half of the light comes from nearer. Pieces must not depend on what is drawn, and near the
    // eye, where a pixel is narrow, they hold no photon.
    const float typical = path.distance_at(chance / 2);
    const float scale = medium.density ? std::min(typical, middle_half(path)) : typical;
    const Pieces pieces = pieces_of(way, typical, scale);
    const PieceChoice choice(path, medium.density != nullptr);
    const float in_piece =
        medium.density ? choice.distance(static_cast<float>(numbers.next())) : here;
    const Piece piece = piece_at(way, pieces, in_piece);
    gather_in(way, piece, choice.chance(piece.begin, piece.end), photon_share(pieces, piece));

    // By angle from a lamp, too, so that the light near one is no noise.
    const auto lamp = lamp_near(pass_.scene, way.origin + way.direction * typical, numbers);
    std::optional<Equiangular> by_angle;
    if (lamp) by_angle.emplace(way, *lamp);
    const float distance =
        by_angle && draws.y < 0.5 ? by_angle->distance_at(static_cast<float>(2 * draws.y)) : here;
    const float free = path.density(distance);
    float density = free / chance;
    if (by_angle) density = (density + by_angle->density(distance)) / 2;
    if (!(density > 0)) return;
    // Camera paths that go on have no share of photons.
    const float share = 1 - photon_share(pieces, piece_at(way, pieces, distance));
    grow_into(distance);
    throughput_ *= path.scattered(distance) * (free / density * share);
    scatter_in_medium(medium, way.origin + way.direction * distance, numbers);
}

/// @param typical  the distance before which half of the light is scattered.
/// @param scale  a length over which half of it is.
CameraPath::Pieces CameraPath::pieces_of(const Ray& way, float typical, float scale) const {
    const float of_pixel = radius_after(way, typical);
    const float most = std::max(kMostOfScale * scale * static_cast<float>(pass_.radius_factor),
                                kLeastOfPixel * of_pixel);
    const float radius = std::min(most, of_pixel);
    const float wide = widening(radius, scale);
    float length = radius * std::max(kPieceOverRadius, kPieceOverWideRadius * wide);
    if (way.length < kInfinity) length = way.length / std::ceil(way.length / length);
    return {length, std::min(1.0F, length / (2 * scale)), radius, most, wide};
}

CameraPath::Piece CameraPath::piece_at(const Ray& way, const Pieces& pieces, float distance) const {
    const float begin = std::floor(distance / pieces.length) * pieces.length;
    const float own = radius_after(way, begin + pieces.length / 2);
    const float radius = std::min(pieces.most, std::max(pieces.radius, own));
    return {begin, begin + pieces.length, radius, pieces.widening};
}

/// Returns what photons bring of the light that comes straight from lights to a piece; light
/// samples bring the rest.
float CameraPath::photon_share(const Pieces& pieces, const Piece& piece) const {
    if (pass_.transport.direct == DirectLight::photons) return 1;
    if (!pass_.direct_in_media) return 0;
    const float volume = kPi * piece.radius * piece.radius * pieces.length;
    return share_of_photons(pass_.direct_in_media->lit, pass_.direct_in_media->photons * volume,
                            pieces.chance);
}

/// Moves into a medium.
void CameraPath::grow_into(float distance) {
    grow_footprint(distance);
    if (!has_hit_) first_footprint_ = footprint_;
}

/// Returns the radius of a pixel's disc at a distance of a way.
float CameraPath::radius_after(const Ray& way, float distance) const {
    CameraPath there(*this);
    there.grow_into(distance);
    return there.radius_at(way.origin + way.direction * distance);
}

/// Gathers photons in a piece of the ray. @param chance  of the piece. @param share  of photons in
/// light that comes straight from lights.
void CameraPath::gather_in(const Ray& way, const Piece& piece, float chance, float share) {
    if (!(chance > 0)) return;  // a density that begins or ends here, by rounding
    const float middle = (piece.begin + piece.end) / 2;
    VisiblePoint point = new_point();
    point.disc.position = way.origin + way.direction * middle;
    point.disc.radius = piece.radius;
    point.disc.indirect_radius_scale = piece.widening;
    point.disc.normal = way.direction;
    point.disc.half_length = (piece.end - piece.begin) / 2;
    const bool all =
        pass_.transport.direct == DirectLight::photons || pass_.direct_in_media.has_value();
    point.disc.kinds =
        static_cast<std::uint8_t>((all ? kAllKinds : kScatteredKinds) << kKindsInMedia);
    point.photon_share = share;
    point.shading_normal = way.direction;
    point.throughput *=
        pass_.scene.transmittance(medium_, {way.origin, way.direction, piece.begin}) / chance;
    point.bsdf = pass_.scene.phase_of(medium_);
    point.medium = medium_;
    points_.push_back(point);
}

/// Adds direct light at a point of a medium, and what camera paths bring of other light.
void CameraPath::scatter_in_medium(const SampledMedium& medium, const Vec3& position,
                                   BatchPoints& numbers) {
    const Bsdf phase = medium.phase;
    const CameraVertex vertex = vertex_in_medium(position, phase);
    const bool goes_beyond = pass_.transport.goes_beyond_diffuse();
    if (pass_.transport.direct == DirectLight::sampled) {
        const bool is_lit = add_direct_light(vertex, numbers, !goes_beyond);
        if (!pass_.lit.empty()) pass_.lit[pixel_] = is_lit ? Lit::lit : Lit::dark;
    }
    if (goes_beyond) go_beyond(vertex, numbers.branch());
}

}  // namespace sunfleck::engine
