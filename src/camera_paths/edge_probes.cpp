// Probes are short rays: through a disc along its normal, from the axis of a cylinder across.
#include "camera_paths/edge_probes.h"

#include "camera_paths/edge_tuning.h"
#include "math/warp.h"
#include "visible_points/sight.h"

namespace sunfleck::engine {
namespace {

class EdgeProber {
public:
    EdgeProber(const PassScene& pass, Probes probes, RandomStream& stream)
        : pass_(pass), probes_(probes), stream_(stream) {}

    void probe(VisiblePoint& point) {
        Disc disc = point.disc;
        if (probes_ == Probes::none && !disc.is_in_medium()) return;
        disc.bounces = 0;
        found_hidden_ = false;
        if (disc.is_probed_for(PhotonKind::direct))
            point.disc_over_surface = disc_over_surface(disc, PhotonKind::direct);
        if (disc.is_probed_for(PhotonKind::indirect))
            point.indirect_disc_over_surface = disc_over_surface(disc, PhotonKind::indirect);
        point.needs_sight = (probes_ == Probes::of_sight && !disc.is_in_medium()) || found_hidden_;
    }

private:
    /// What probes have met.
    struct Met {
        float probes = 0;   // that lie on a surface
        float cosines = 0;  // their sum
    };

    /// Returns an estimate of disc over surface. One over the share s of the disc that has any
    /// surface is 1 + (1 - s) + (1 - s)^2 + ..., whose powers are products over independent pairs
    /// of probes. The mean cosine takes account of slanted surface, which is larger than what it
    /// covers of the disc. @param kind  one that is accepted.
    float disc_over_surface(const Disc& disc, PhotonKind kind) {
        Met all;
        float sum = 1;
        float term = 1;
        for (int k = 1; k < kMostTerms; ++k) {
            term *= 1 - probe_pair(disc, kind, all);
            if (term < kLeastTerm) {
                if (!(static_cast<float>(stream_.next()) * kLeastTerm < term)) break;
                term = kLeastTerm;
            }
            sum += term;
        }
        return all.probes > 0 ? sum * all.cosines / all.probes : sum;
    }

    /// Probes two opposite points of a disc: of a straight edge's disc, one always has surface.
    /// @return the share of them that has.
    float probe_pair(const Disc& disc, PhotonKind kind, Met& all) {
        const Vec3 way = random_way(disc, kind);
        if (disc.is_in_medium()) return probe_pair_of_cylinder(disc, way, all);
        float met = 0;
        for (const Vec3& at : {disc.position + way, disc.position - way}) {
            const float cosine = cosine_at(at, disc, kind);
            if (!(cosine > 0)) continue;
            all.cosines += cosine;
            ++all.probes;
            met += 0.5F;
        }
        return met;
    }

    /// Returns a way from the middle of a disc to a random point of it.
    Vec3 random_way(const Disc& disc, PhotonKind kind) {
        const Vec2d u = concentric_disc({stream_.next(), stream_.next()});
        const Frame frame(disc.normal);
        return (frame.x * static_cast<float>(u.x) + frame.y * static_cast<float>(u.y)) *
               disc.radius_for(kind);
    }

    /// Probes two opposite points at a random place of the axis. @return the share of them that
    /// the axis sees.
    float probe_pair_of_cylinder(const Disc& cylinder, const Vec3& way, Met& all) {
        const auto along = static_cast<float>(2 * stream_.next() - 1) * cylinder.half_length;
        const Vec3 middle = cylinder.position + cylinder.normal * along;
        float met = 0;
        for (const Vec3& at : {middle + way, middle - way}) {
            if (!axis_sees(pass_.scene.geometry(), cylinder, at)) {
                found_hidden_ = true;
                continue;
            }
            ++all.cosines;
            ++all.probes;
            met += 0.5F;
        }
        return met;
    }

    /// Returns the cosine between the disc and a surface at a point of the disc; zero if there is
    /// none whose photons count. A surface that is there in part counts as a whole one: photons are
    /// stored at all of it.
    float cosine_at(const Vec3& at, const Disc& disc, PhotonKind kind) {
        const Geometry& geometry = pass_.scene.geometry();
        const float radius = disc.radius_for(kind);
        const float step = 1e-4F * radius;  // past a surface that was met
        float from = radius;
        for (int k = 0; k < kMostSurfaces && from > -radius; ++k) {
            const Ray ray{at + disc.normal * from, -disc.normal, from + radius};
            Hit hit;
            if (!geometry.complete(geometry.trace(ray, AlphaTest::off), hit)) return 0;
            const Photon photon = photon_at(hit, disc, kind);
            if (pass_.may_gather(pass_.scene.material_of(hit)) && accepts(disc, photon, 1))
                return counts(disc, photon) ? photon.normal.dot(disc.normal) : 0;
            from -= hit.distance + step;
        }
        return 0;
    }

    bool counts(const Disc& disc, const Photon& photon) {
        if (probes_ == Probes::of_surface) return true;
        if (sees(pass_.scene.geometry(), disc, photon)) return true;
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
