// Probes are short rays through a disc, along its normal.
#include "camera_paths/edge_probes.h"

#include "visible_points/sight.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// A disc with less surface than about a sixteenth of it keeps a part of its loss: a wire, a blade
/// of grass. More would be noise.
constexpr int kMostProbes = 16;
/// Surfaces that a probe looks at: others may lie above.
constexpr int kMostSurfaces = 4;

class EdgeProber {
public:
    EdgeProber(const PassScene& pass, Probes probes, RandomStream& stream)
        : pass_(pass), probes_(probes), stream_(stream) {}

    void probe(VisiblePoint& point) {
        constexpr std::array<PhotonKind, 3> kOfRadius = {PhotonKind::caustic, PhotonKind::indirect,
                                                         PhotonKind::long_specular_chain};
        Disc disc = point.disc;
        disc.bounces = 0;
        if (disc.accepts_kind(PhotonKind::direct))
            disc.kinds |= static_cast<std::uint8_t>(PhotonKind::caustic);
        found_hidden_ = false;
        for (const PhotonKind kind : kOfRadius)
            if (disc.accepts_kind(kind))
                point.disc_over_surface.at(radius_number(kind)) = disc_over_surface(disc, kind);
        point.needs_sight = probes_ == Probes::of_sight || found_hidden_;
    }

private:
    /// Returns an estimate of disc over surface: the number of probes until one meets a surface,
    /// whose mean is one over the share that has any, times the cosine there, for slanted surface
    /// is larger than what it covers of the disc. @param kind  one that is accepted.
    float disc_over_surface(const Disc& disc, PhotonKind kind) {
        for (int probes = 1; probes < kMostProbes; ++probes) {
            const float cosine = cosine_met(disc, kind);
            if (cosine > 0) return static_cast<float>(probes) * cosine;
        }
        return kMostProbes;
    }

    /// Returns the cosine between the disc and a surface at a random point of the disc; zero if
    /// there is none whose photons count. A surface that is there in part counts as a whole one:
    /// photons are stored at all of it.
    float cosine_met(const Disc& disc, PhotonKind kind) {
        const Geometry& geometry = pass_.scene.geometry();
        const float radius = disc.radius_for(kind);
        const float out = radius * std::sqrt(static_cast<float>(stream_.next()));
        const float angle = 2 * kPi * static_cast<float>(stream_.next());
        const Frame frame(disc.normal);
        const Vec3 at =
            disc.position + frame.x * (out * std::cos(angle)) + frame.y * (out * std::sin(angle));
        const float step = 1e-4F * radius;  // past a surface that was met
        float from = radius;
        for (int k = 0; k < kMostSurfaces && from > -radius; ++k) {
            const Ray ray{at + disc.normal * from, -disc.normal, from + radius};
            Hit hit;
            if (!geometry.complete(geometry.trace(ray, AlphaTest::off), hit)) return 0;
            const Photon photon = photon_at(hit, disc, kind);
            if (pass_.may_gather(pass_.scene.material_of(hit)) && accepts(disc, photon, 1))
                return counts(disc, photon, radius) ? photon.normal.dot(disc.normal) : 0;
            from -= hit.distance + step;
        }
        return 0;
    }

    bool counts(const Disc& disc, const Photon& photon, float radius) {
        if (probes_ == Probes::of_surface) return true;
        if (sees(pass_.scene.geometry(), disc, photon.position, photon.normal, radius)) return true;
        found_hidden_ = true;
        return false;
    }

    /// Returns a photon that arrives there on the disc's side.
    static Photon photon_at(const Hit& hit, const Disc& disc, PhotonKind kind) {
        Photon photon;
        photon.position = hit.position;
        photon.normal = hit.normal.dot(disc.normal) < 0 ? -hit.normal : hit.normal;
        photon.kind = kind;
        return photon;
    }

    const PassScene& pass_;
    Probes probes_;
    RandomStream& stream_;
    bool found_hidden_ = false;  // for the current point
};

}  // namespace

void probe_edges(const PassScene& pass, std::span<VisiblePoint> points, Probes probes,
                 RandomStream stream) {
    EdgeProber prober(pass, probes, stream);
    for (VisiblePoint& point : points) prober.probe(point);
}

}  // namespace sunfleck::engine
