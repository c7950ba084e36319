// Random walks over surfaces, with a light sample at each vertex.
#include "photon/importons.h"

#include "core/parallel.h"
#include "math/warp.h"
#include "photon/initial_guide_samples.h"
#include "photon/scattering_event.h"

namespace sunfleck::engine {
namespace {

constexpr int kMostBounces = 16;

class Importon {
public:
    Importon(const PhotonContext& photon_context, const LightChoice& lights, RandomStream stream,
             WalkedEmission& found)
        : scene_(photon_context.scene),
          goes_beyond_diffuse_(photon_context.transport.goes_beyond_diffuse()),
          guide_samples_(photon_context.scene, lights),
          stream_(stream),
          found_(found) {}

    void start(const Disc& disc) {
        if (disc.is_in_medium()) {
            start_in_medium(disc);
            return;
        }
        Vec3 normal = disc.normal;
        if (disc.both_sides && stream_.next() < 0.5) normal = -normal;
        const Vec3 from = disc.position + normal * (1e-3F * disc.radius);
        look_for_light(from, disc, normal);
        const Vec3d local = cosine_hemisphere({stream_.next(), stream_.next()});
        go_on({from, Frame(normal).to_world(Vec3(local))});
    }

private:
    /// Starts in any direction from any point of a cylinder's axis.
    void start_in_medium(const Disc& disc) {
        const float along = disc.half_length * (2 * stream_.next_float() - 1);
        const Vec3 from = disc.position + disc.normal * along;
        if (const auto sample = guide_samples_.sample(from, stream_))
            add_if_accepted(disc, from, *sample, 1 / (4 * kPi));
        go_on({from, Vec3(uniform_sphere({stream_.next(), stream_.next()}))});
    }

    /// Samples light at the first vertex of a walk, where camera paths may compute direct light.
    void look_for_light(const Vec3& at, const Disc& disc, const Vec3& normal) {
        const auto sample = guide_samples_.sample(at, stream_);
        if (!sample) return;
        const float cosine = normal.dot(sample->direct.direction);
        if (cosine > 0) add_if_accepted(disc, at, *sample, cosine / kPi);
    }

    /// Adds a light sample that a visible point gathers. @param scattered  per steradian.
    void add_if_accepted(const Disc& disc, const Vec3& at, const LightAtPoint& sample,
                         float scattered) {
        const double weight = weight_of(sample, SampledSpectrum(scattered));
        const int panes =
            guide_samples_.panes_to({at, sample.direct.direction}, sample.direct.distance);
        const PhotonKind kind = kind_after_smooth(panes);
        if (panes < 0 || !disc.accepts_kind(kind)) return;
        add(sample, at, weight);
    }

    void go_on(Ray ray) {
        for (int bounces = 0; bounces < kMostBounces; ++bounces) {
            auto hit = scene_.scene.geometry().intersect(ray);
            for (int panes = 0; hit && scene_.scene.is_null_interface(*hit); ++panes) {
                if (panes == kMostPanes) return;
                hit = scene_.scene.geometry().intersect(ray_from(*hit, ray.direction));
            }
            if (!hit) return;
            std::optional<Bsdf> room;
            const Bsdf bsdf = scene_.bsdf_at(*hit, room);
            const Frame frame(hit->shading_normal, hit->tangent);
            const Vec3 wo = frame.to_local(-ray.direction);
            if (scattering(bsdf) != Scattering::specular) {
                const auto sample = guide_samples_.sample(hit->position, stream_);
                if (sample) add_if_lit(*hit, frame, bsdf, wo, *sample);
            }
            const auto drawn = sample(bsdf, wo, draw());
            if (!drawn) return;
            const SampledSpectrum throughput = throughput_ * drawn->weight;
            const float survival = std::min(1.0F, throughput.sum() / throughput_.sum());
            if (!(stream_.next_float() < survival)) return;
            throughput_ = throughput / survival;
            ray = ray_from(*hit, frame.to_world(drawn->wi));
        }
    }

    BsdfSampleInput draw() {
        const float lobe = stream_.next_float();
        const float u = stream_.next_float();
        return {{lobe, u, stream_.next_float()}, Transport::radiance, {}};
    }

    void add_if_lit(const Hit& hit, const Frame& frame, const Bsdf& bsdf, const Vec3& wo,
                    const LightAtPoint& sample) {
        const Vec3 wi = frame.to_local(sample.direct.direction);
        const SampledSpectrum f = eval(bsdf, wo, wi, Transport::radiance);
        if (f.is_zero()) return;
        const double weight = weight_of(sample, f * std::abs(wi.z));
        const Ray ray = ray_from(hit, sample.direct.direction);
        const int panes = guide_samples_.panes_to(ray, sample.direct.distance);
        if (panes < 0 || (panes == 0 && is_left_to_camera(bsdf))) return;
        add(sample, hit.position, weight);
    }

    /// Returns whether camera paths bring what this surface sends on of light straight from a lamp.
    bool is_left_to_camera(const Bsdf& bsdf) const {
        return goes_beyond_diffuse_ && scattering(bsdf) == Scattering::diffuse;
    }

    /// Returns the unoccluded contribution of a sample.
    double weight_of(const LightAtPoint& sample, const SampledSpectrum& scattered) {
        const SampledSpectrum flux =
            throughput_ * scattered * guide_samples_.emitted_by(sample.light);
        const double weight = static_cast<double>(flux.sum()) *
                              static_cast<double>(sample.direct.factor) / sample.probability;
        found_.possible += weight;
        return weight;
    }

    void add(const LightAtPoint& sample, const Vec3& at, double weight) {
        if (const auto guide_sample = guide_samples_.guide_sample(sample, at, weight, stream_))
            found_.guide_samples.push_back(*guide_sample);
    }

    const PassScene& scene_;
    bool goes_beyond_diffuse_;
    InitialGuideSamples guide_samples_;
    RandomStream stream_;
    WalkedEmission& found_;
    SampledSpectrum throughput_{1};
};

/// @param kinds  of photons that visible points accept; zero: as each point does.
WalkedEmission walk(const PhotonContext& photon_context, const LightChoice& lights, PassId pass,
                    const PathRange& walks, std::uint8_t kinds) {
    constexpr std::size_t kBlock = 1024;
    const std::size_t count = walks.size();
    const std::span<const VisiblePoint> points = photon_context.index.points();
    std::vector<WalkedEmission> blocks((count + kBlock - 1) / kBlock);
    parallel_blocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            RandomStream stream = pass.stream(Purpose::importon, walks.begin + i);
            const auto point =
                static_cast<std::size_t>(stream.next() * static_cast<double>(points.size()));
            Disc disc = points[point].disc;
            disc.kinds |= kinds;
            Importon(photon_context, lights, stream, blocks[begin / kBlock]).start(disc);
        }
    });
    WalkedEmission all;
    for (const WalkedEmission& block : blocks) {
        all.guide_samples.insert(all.guide_samples.end(), block.guide_samples.begin(),
                                 block.guide_samples.end());
        all.possible += block.possible;
    }
    return all;
}

}  // namespace

WalkedEmission trace_importons(const PhotonContext& photon_context, const LightChoice& lights,
                               PassId pass, const PathRange& walks) {
    return walk(photon_context, lights, pass, walks, 0);
}

double flux_seen(const PhotonContext& photon_context, PassId pass) {
    constexpr std::uint32_t kWalks = 20'000;
    const WalkedEmission found = walk(photon_context, photon_context.scene.scene.light_choice(),
                                      pass, {0, kWalks}, kAllKinds);
    double flux = 0;
    for (const WeightedEmission& guide_sample : found.guide_samples) flux += guide_sample.weight;
    return flux / kWalks;
}

}  // namespace sunfleck::engine
