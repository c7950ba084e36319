// PhotonTracer: a photon path as a function of its primary sample, from a light through surface
// after surface, and where media scatter it.
//
// In:  a primary-sample reader (the point u), the scene at the wavelengths of a pass. Out: each
// photon at a surface that can gather is passed to a visitor, which may end the path.
// Source: shading-normal correction: Veach 1997, section 5.3.2; Russian roulette on the throughput
// keeps the flux of photons about constant, as the paper's binary target assumes.
// Equations: docs/method/method.md, eqs. (8) and (9).
#pragma once

#include "aovs/statistics.h"
#include "aovs/transport.h"
#include "photon/path_end.h"
#include "photon/photon_emission.h"
#include "photon/photon_flight.h"
#include "photon/scattering_event.h"
#include "scene/pass_scene.h"

#include <concepts>
#include <optional>

namespace sunfleck::engine {

/// Called with each photon.
template <class V>
concept PhotonVisitor = std::invocable<V&, const Photon&>;

class PhotonTracer {
public:
    PhotonTracer(const PassScene& pass, const TransportSettings& transport)
        : PhotonTracer(pass, transport, pass.scene.light_choice()) {}

    /// @param lights  in which paths start: some or all of the scene's.
    PhotonTracer(const PassScene& pass, const TransportSettings& transport,
                 const LightChoice& lights)
        : pass_(pass), transport_(transport), lights_(lights), has_media_(pass.scene.has_media()) {}

    /// Traces one complete path. @param rays  counts the rays.
    template <PrimarySampleReader Reader, PhotonVisitor Visitor>
    PathEnd trace(Reader&& read, Visitor&& visit, std::uint64_t& rays) const {
        PhotonState state;
        if (!start(read, state)) return PathEnd::no_light;
        for (;;) {
            ++rays;
            Hit hit;
            if (!complete(send(state), state, hit)) return PathEnd::escaped;
            if (const auto end = go_on(read, visit, hit, state)) return *end;
        }
    }

    // Steps of a path, for callers that interleave paths: start(), then send(), complete() and
    // go_on() until it ends.

    /// Samples a light: flux, position and direction of the photon.
    /// @return false if nothing is emitted.
    template <PrimarySampleReader Reader>
    bool start(Reader& read, PhotonState& state) const {
        const std::optional<Emission> from = emit(read, pass_, transport_, lights_, state);
        if (!from) return false;
        state.origin = from->origin;
        state.first_direction = from->direction;
        state.unlit = static_cast<float>(from->unlit);
        state.lit_to = static_cast<float>(from->lit_to);
        return true;
    }

    /// Traces the ray of a photon without alpha test; go_on() applies it.
    RayHit send(const PhotonState& state) const {
        const Geometry& geometry = pass_.scene.geometry();
        if (state.at_light)
            return geometry.trace_precise(state.origin, state.first_direction, AlphaTest::off);
        return geometry.trace({Vec3(state.origin), state.direction}, AlphaTest::off);
    }

    /// Computes the hit. @return whether there is one. Where there is none, but a medium that may
    /// scatter the photon, it is infinitely far, and of no shape.
    bool complete(const RayHit& ray_hit, const PhotonState& state, Hit& hit) const {
        if (pass_.scene.geometry().complete(ray_hit, hit)) return true;
        if (!has_media_ || !pass_.media[state.medium].scatters) return false;
        hit.distance = kInfinity;
        hit.shape = kNone;
        return true;
    }

    /// Handles a hit up to the next ray. @return how the path ends, if it does.
    template <PrimarySampleReader Reader, PhotonVisitor Visitor>
    std::optional<PathEnd> go_on(Reader& read, Visitor&& visit, const Hit& hit,
                                 PhotonState& state) const {
        if (has_media_) {
            const Crossing crossing = cross_medium(read, visit, hit, state);
            if (!crossing.reaches_hit) return crossing.end;
        }
        if (state.lit_to < kInfinity && is_beyond_light(hit, state)) return PathEnd::escaped;
        if (pass_.scene.has_cover(hit) && !is_there(hit, state))
            return go_through_absent_surface(visit, hit, state);
        if (state.unlit > 0 && is_stopped(hit, state)) return PathEnd::absorbed;
        const auto& constant = pass_.bsdfs[pass_.scene.material_of(hit)];
        if (constant) return interact(read, visit, *constant, hit, state);
        if (!pass_.scene.is_null_interface(hit)) return interact_varied(read, visit, hit, state);
        leave(hit, state);
        return {};
    }

    // go_on() in three steps, for callers that sample the events of many photons together.

    /// First step. @return the surface; null if go_on() is to be called in place of the steps.
    const Lambert* plain_surface(const Hit& hit, const PhotonState& state) const {
        if (state.unlit > 0 || state.lit_to < kInfinity || has_media_ || pass_.scene.has_cover(hit))
            return nullptr;
        const auto& constant = pass_.bsdfs[pass_.scene.material_of(hit)];
        return constant ? std::get_if<Lambert>(&*constant) : nullptr;
    }
    /// Second step. @return how the path ends, if it does; otherwise sample_scattering() follows.
    template <PhotonVisitor Visitor>
    std::optional<PathEnd> visit_photon(Visitor&& visit, const Hit& hit,
                                        const PhotonState& state) const {
        if (is_left_to_camera(state)) return PathEnd::absorbed;
        visit(photon_at(hit, state));
        if (state.bounces + 1 >= transport_.max_depth) return PathEnd::too_long;
        return {};
    }
    /// Third step: applies the sampled event. @return how the path ends, if it does.
    std::optional<PathEnd> after_event(const ScatteringEvent& event, const Hit& hit,
                                       PhotonState& state) const {
        if (!apply_event(event, state)) return PathEnd::absorbed;
        leave(hit, state);
        return {};
    }

private:
    /// Returns whether camera paths bring what a diffuse surface scatters of this photon.
    bool is_left_to_camera(const PhotonState& state) const {
        return state.bounces == 0 && transport_.goes_beyond_diffuse();
    }

    [[gnu::noinline]] bool is_there(const Hit& hit, const PhotonState& state) const {
        return pass_.scene.geometry().is_there(hit, state.origin, state.direction);
    }

    /// Handles a surface whose alpha test fails for this photon: its visible points still gather
    /// the photon, because they passed an alpha test of their own. Light that arrives at a surface
    /// does not depend on its alpha.
    template <PhotonVisitor Visitor>
    [[gnu::noinline]] std::optional<PathEnd> go_through_absent_surface(Visitor& visit,
                                                                       const Hit& hit,
                                                                       PhotonState& state) const {
        const bool is_lit = !(hit.distance < state.unlit);
        state.unlit = std::max(0.0F, state.unlit - hit.distance);
        if (is_lit && pass_.may_gather(pass_.scene.material_of(hit))) visit(photon_at(hit, state));
        state.at_light = false;
        state.origin = Vec3d(ray_from(hit, state.direction).origin);
        return {};
    }

    /// What a medium did to a photon on its way to a hit.
    struct Crossing {
        bool reaches_hit = false;
        std::optional<PathEnd> end;  // if not; none if it has been scattered and goes on
    };

    template <PrimarySampleReader Reader, PhotonVisitor Visitor>
    [[gnu::noinline]] Crossing cross_medium(Reader& read, Visitor& visit, const Hit& hit,
                                            PhotonState& state) const {
        const SampledMedium& medium = pass_.media[state.medium];
        const Ray way{Vec3(state.origin), state.direction, hit.distance};
        if (!medium.scatters) return {keep(transmittance(medium, way), state), PathEnd::absorbed};
        const Flight flight = sample_flight(read, medium, way, state);
        if (!keep(flight.weight, state)) return {false, PathEnd::absorbed};
        if (flight.is_scattered)
            return {false, scatter_in_medium(read, visit, medium, flight.distance, state)};
        return {hit.shape != kNone, PathEnd::escaped};
    }

    /// Visits a photon where a medium scatters it, and scatters it.
    template <PrimarySampleReader Reader, PhotonVisitor Visitor>
    std::optional<PathEnd> scatter_in_medium(Reader& read, Visitor& visit,
                                             const SampledMedium& medium, float distance,
                                             PhotonState& state) const {
        const bool is_last = is_left_to_camera(state);
        const bool is_lit = !(distance < state.unlit || distance > state.lit_to);
        if (!is_lit || (is_last && !is_of_medium(state))) return PathEnd::absorbed;
        move_on(distance, state);
        const Photon photon = photon_in_medium(state);
        visit(photon);
        if (is_last) return PathEnd::absorbed;
        if (state.bounces + 1 >= transport_.max_depth) return PathEnd::too_long;
        if (!scatter_at(read, medium.phase, point_in_medium(photon.position), state))
            return PathEnd::absorbed;
        return {};
    }

    [[gnu::noinline]] void enter_beyond(const Hit& hit, PhotonState& state) const {
        state.medium = pass_.scene.medium_beyond(hit, state.direction, state.medium);
    }

    /// Prepares the next ray.
    void leave(const Hit& hit, PhotonState& state) const {
        state.at_light = false;
        if (has_media_) enter_beyond(hit, state);
        state.origin = Vec3d(ray_from(hit, state.direction).origin);
    }

    /// Returns true if the photon hit something before it passed the portal.
    bool is_stopped(const Hit& hit, PhotonState& state) const {
        const bool before = hit.distance < state.unlit;
        state.unlit -= hit.distance;
        return before && !pass_.scene.is_null_interface(hit);
    }

    /// Returns whether a photon has come further than its light; if not, tells it how far that goes
    /// on.
    [[gnu::noinline]] static bool is_beyond_light(const Hit& hit, PhotonState& state) {
        if (hit.distance > state.lit_to) return true;
        state.lit_to -= hit.distance;
        return false;
    }

    /// Visits the photon and scatters it. @return how the path ends, if it does.
    template <PrimarySampleReader Reader, PhotonVisitor Visitor>
    [[gnu::always_inline]] inline std::optional<PathEnd> interact(Reader& read, Visitor& visit,
                                                                  const Bsdf& bsdf, const Hit& hit,
                                                                  PhotonState& state) const {
        if (is_left_to_camera(state)) {
            const auto* coated = std::get_if<CoatedDiffuse>(&bsdf);
            const bool is_diffuse = scattering(bsdf) == Scattering::diffuse;
            if ((is_diffuse || coated != nullptr) && is_of_medium(state))
                visit(photon_at(hit, state));
            if (is_diffuse) return PathEnd::absorbed;
            if (coated != nullptr) return interact_with_coat(read, *coated, hit, state);
        }
        const auto* lambert = std::get_if<Lambert>(&bsdf);
        const bool gathers = lambert != nullptr || pass_.may_gather(pass_.scene.material_of(hit));
        if (gathers) visit(photon_at(hit, state));
        if (state.bounces + 1 >= transport_.max_depth) return PathEnd::too_long;
        const bool goes_on = lambert != nullptr ? scatter_at(read, *lambert, hit, state)
                                                : scatter(read, bsdf, hit, state);
        if (!goes_on) return PathEnd::absorbed;
        leave(hit, state);
        return {};
    }

    /// Scatters a photon at the coat alone: camera paths bring what the base scatters.
    template <PrimarySampleReader Reader>
    [[gnu::noinline]] std::optional<PathEnd> interact_with_coat(Reader& read,
                                                                const CoatedDiffuse& coated,
                                                                const Hit& hit,
                                                                PhotonState& state) const {
        if (state.bounces + 1 >= transport_.max_depth) return PathEnd::too_long;
        if (!scatter(read, Bsdf(coated.top()), hit, state)) return PathEnd::absorbed;
        leave(hit, state);
        return {};
    }

    /// interact() for a material that is textured or a mix; a separate function, to keep the usual
    /// one short.
    template <PrimarySampleReader Reader, PhotonVisitor Visitor>
    [[gnu::noinline]] std::optional<PathEnd> interact_varied(Reader& read, Visitor& visit,
                                                             const Hit& hit,
                                                             PhotonState& state) const {
        Hit bent = hit;
        std::optional<Bsdf> room;
        const Bsdf& bsdf = pass_.bsdf_at(bent, room);
        return interact(read, visit, bsdf, bent, state);
    }

    /// Applies one scattering event. @return false if the photon is absorbed.
    template <PrimarySampleReader Reader>
    static bool scatter(Reader& read, const Bsdf& at_surface, const Hit& hit, PhotonState& state) {
        if (!is_dispersive(at_surface)) return scatter_at(read, at_surface, hit, state);
        choose_wavelength(read, state);
        if (scattering(at_surface) != Scattering::specular)
            terminate_secondary(state.flux, state.hero);
        if (!state.hero.single) return scatter_at(read, at_surface, hit, state);
        return scatter_at(read, at_wavelength(at_surface, state.hero.chosen), hit, state);
    }

    template <PrimarySampleReader Reader, class Surface>
    static bool scatter_at(Reader& read, const Surface& bsdf, const Hit& hit, PhotonState& state) {
        return apply_event(sample_scattering(read, bsdf, hit, state), state);
    }

    template <PrimarySampleReader Reader>
    static void choose_wavelength(Reader& read, PhotonState& state) {
        if (state.hero_read) return;
        state.hero.chosen = hero_of(to_unit(read(dimension(EmissionDimension::hero))));
        state.hero_read = true;
    }

    const PassScene& pass_;
    const TransportSettings& transport_;
    const LightChoice& lights_;
    const bool has_media_;
};

}  // namespace sunfleck::engine
