// CameraPath: traces one camera path through specular surfaces to visible points, with emission and
// direct light on the way, and the light of media along each ray. At smooth glass the path splits
// into reflection and refraction, as long as neither branch has a small weight, so that the choice
// between them causes no noise. (A lobe of 4% that leads to a lamp would cause most of a pixel's
// noise.)
#pragma once

#include "aovs/pass_image.h"
#include "camera/filter.h"
#include "camera_paths/camera_pass.h"
#include "camera_paths/next_event_estimation.h"
#include "medium/free_way.h"
#include "random_numbers/batch_points.h"
#include "visible_points/visible_point.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

class CameraPath {
public:
    /// Visible points are appended to `points`, light is added to `image`.
    CameraPath(const CameraPass& pass, const FilterSampler& filter, PassImage& image,
               std::vector<VisiblePoint>& points, Statistics& statistics)
        : pass_(pass), filter_(filter), image_(image), points_(points), statistics_(statistics) {}

    /// @param pixel  index in the window of the pass. @param path  index among the pixel's paths.
    void trace(std::uint32_t pixel, const PathOfPixel& path);

private:
    /// Which emitters at the next hit count, by the last vertex of the path.
    enum class Emitters {
        all,       // only specular surfaces since the camera: no other estimator finds them
        weighted,  // directly after a glossy vertex: the bsdf sample of MIS
        none       // by specular surfaces after a glossy vertex: photons bring that light
    };

    CameraRay start(BatchPoints& numbers);
    void follow(std::optional<Hit> hit, BatchPoints& numbers);
    /// Returns the next ray from a hit, in the new direction.
    Ray ray_beyond(const Hit& hit);
    /// What a medium does to a path on its way to a hit.
    enum class Crossing { passed, scattered, ended };
    Crossing cross_medium(std::optional<Hit>& hit, BatchPoints& numbers);
    Crossing fly_beyond(const SampledMedium& medium, const Ray& way, std::optional<Hit>& hit,
                        BatchPoints& numbers);
    CameraVertex vertex_in_medium(const Vec3& position, const Bsdf& phase) const;
    void look_into(const SampledMedium& medium, const Ray& way, BatchPoints numbers);
    void add_glow(const SampledMedium& medium, const Ray& way, BatchPoints& numbers);
    void grow_into(float distance);
    float radius_after(const Ray& way, float distance) const;
    /// The equal pieces of a way, in each of which photons may count.
    struct Pieces {
        float length;
        float chance;    // of one, nearly: the same for all
        float radius;    // at the least
        float most;      // at the most
        float widening;  // of the radius, for indirect light
    };
    Pieces pieces_of(const Ray& way, float typical, float scale) const;
    /// A part of a way, by distances.
    struct Piece {
        float begin;
        float end;
        float radius;
        float widening;  // of that, for indirect light
    };
    Piece piece_at(const Ray& way, const Pieces& pieces, float distance) const;
    float photon_share(const Pieces& pieces, const Piece& piece) const;
    void gather_in(const Ray& way, const Piece& piece, float chance, float share);
    void scatter_in_medium(const SampledMedium& medium, const Vec3& position, BatchPoints& numbers);
    bool interact(Hit& hit, BatchPoints& numbers);
    void go_beyond(const CameraVertex& vertex, BatchPoints numbers);
    bool interact_beyond(const CameraVertex& vertex, const Bsdf& at_surface, BatchPoints& numbers);
    void gather_at_base(const CameraVertex& vertex, BatchPoints& numbers);
    bool go_on(const CameraVertex& vertex, BatchPoints& numbers);
    void add_emission(const EmitterHit& met);
    Aov owner_of_emission() const;
    /// @param radiance  incident radiance, the sum of contributions_.
    void add_light(const SampledSpectrum& radiance, float weight, Aov owner);
    LightContributions* wanted_contributions() {
        return image_.light_groups() > 0 ? &contributions_ : nullptr;
    }
    void add_features(const Hit& hit, const SampledSpectrum& reflectance);
    void add_transmittance();
    void gather(const Hit& hit, const Bsdf& bsdf, std::uint8_t kinds);
    VisiblePoint new_point() const;
    bool add_direct_light(const CameraVertex& vertex, BatchPoints& numbers, bool follow);
    bool scatter(const CameraVertex& vertex, BatchPoints& numbers);
    /// Continues by one bsdf sample as a branch with weight `share`. @return whether it does.
    bool take(const CameraVertex& vertex, const BsdfSampleInput& draw, float share,
              double roulette);
    /// Returns an estimate of the weight of further light in the pixel; 1 at the camera.
    float importance() const;
    void grow_footprint(float distance);
    float radius_at(const Vec3& position) const;

    const CameraPass& pass_;
    const FilterSampler& filter_;
    PassImage& image_;
    std::vector<VisiblePoint>& points_;
    Statistics& statistics_;

    std::uint32_t pixel_ = 0;
    bool has_hit_ = false;  // the path has hit a surface
    bool has_features_ = false;
    SampledSpectrum media_left_{1};  // before them: what media leave of light from here
    float of_pixel_ = 1;             // weight of this path in the pixel
    float weight_ = 1;               // of the pixel filter, the exposure and of_pixel_
    SampledSpectrum throughput_;
    HeroWavelength hero_;
    Vec3 position_{0};  // of the last vertex
    Vec3 from_{0};      // origin of the next ray
    Vec3 direction_{0};
    MediumNumber medium_ = 0;    // of the next ray
    float length_ = 0;           // of the path so far
    float footprint_ = 0;        // width of the pixel at the current vertex
    float footprint_angle_ = 0;  // its growth per distance
    float first_footprint_ = 0;  // at the first surface
    float spread_ = 0;           // width that glossy lobes add
    float spread_angle_ = 0;     // its growth per distance
    float eta_scale_ = 1;        // squared index ratio of refractions, undone for Russian roulette
    float share_ = 1;            // product of the branch weights
    bool beyond_ = false;        // a diffuse surface has scattered the path: nothing is gathered
    int events_beyond_ = 0;      // scattering events since then, that first one included
    std::uint16_t bounces_ = 0;
    Emitters emitters_ = Emitters::all;
    float bsdf_pdf_ = 0;                // of the last glossy sample, over the RIS candidates there
    Receiver glossy_;                   // the vertex of that sample
    std::size_t rough_ = 0;             // count of glossy vertices
    LightContributions contributions_;  // of the light that is added next
};

}  // namespace sunfleck::engine
