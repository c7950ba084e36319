// One camera path: through smooth surfaces to what gathers, with the light that it finds itself. At
// smooth glass it parts, and both ways are followed, as long as neither is worth little: which of
// them light takes is no chance then. (A choice of 4% that leads to a lamp is most of a pixel's
// noise.)
#pragma once

#include "aovs/pass_image.h"
#include "camera/filter.h"
#include "camera_paths/camera_pass.h"
#include "camera_paths/next_event_estimation.h"
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

    /// @param pixel  index in the pass's window. @param path  which of the pixel's.
    void trace(std::uint32_t pixel, const PathOfPixel& path);

private:
    /// What an emitter met by the next hit counts, by the vertex that the path left last.
    enum class Emitters {
        all,       // only smooth surfaces since the camera: nobody else brings it
        weighted,  // straight after a glossy vertex: the bsdf's half of MIS
        none       // by smooth surfaces after a glossy vertex: photons bring it
    };

    CameraRay start(BatchPoints& numbers);
    void follow(std::optional<Hit> hit, BatchPoints& numbers);
    /// On from a hit, in the new direction.
    Ray ray_beyond(const Hit& hit);
    bool meet(Hit& hit, BatchPoints& numbers);
    void meet_base(const CameraVertex& vertex, BatchPoints& numbers);
    bool go_on(const CameraVertex& vertex, BatchPoints& numbers);
    void add_emission(const EmitterMet& met);
    /// @param radiance  that arrives, of which parts_ are parts.
    void add_light(const SampledSpectrum& radiance, float weight, Aov owner);
    LightParts* wanted_parts() { return image_.light_groups() > 0 ? &parts_ : nullptr; }
    void add_features(const Hit& hit, const SampledSpectrum& reflectance);
    void gather(const Hit& hit, const Bsdf& bsdf, std::uint8_t kinds);
    void add_direct_light(const CameraVertex& vertex, BatchPoints& numbers, bool follow);
    bool scatter(const CameraVertex& vertex, BatchPoints& numbers);
    /// Goes on by one bsdf sample, as a branch with that share of the light. @return whether it
    /// does.
    bool take(const CameraVertex& vertex, const BsdfDraw& draw, float share, double roulette);
    /// What light from here on counts in the pixel, about; 1 at the camera.
    float importance() const;
    void grow_footprint(const Hit& hit);
    float radius_at(const Hit& hit) const;

    const CameraPass& pass_;
    const FilterSampler& filter_;
    PassImage& image_;
    std::vector<VisiblePoint>& points_;
    Statistics& statistics_;

    std::uint32_t pixel_ = 0;
    bool has_met_ = false;  // a surface
    bool has_features_ = false;
    float of_pixel_ = 1;  // this path's share of the pixel's light
    float weight_ = 1;    // of the pixel filter, and of the film's exposure, of that share
    SampledSpectrum throughput_;
    HeroWavelength hero_;
    Vec3 position_{0};  // of the last vertex
    Vec3 direction_{0};
    MediumNumber medium_ = 0;    // of the next ray
    float length_ = 0;           // of the path so far
    float footprint_ = 0;        // width of the pixel here
    float footprint_angle_ = 0;  // its growth per distance
    float first_footprint_ = 0;  // at the first surface
    float spread_ = 0;           // width that glossy lobes add here
    float spread_angle_ = 0;     // its growth per distance
    float eta_scale_ = 1;        // undoes the radiance's factor of refraction for Russian roulette
    float share_ = 1;            // of the light: of the branches taken where the path parted
    std::uint16_t bounces_ = 0;
    Emitters emitters_ = Emitters::all;
    float bsdf_pdf_ = 0;     // of the last glossy sample, over the RIS candidates there
    Receiver glossy_;        // its vertex
    std::size_t rough_ = 0;  // glossy vertices so far
    LightParts parts_;       // of light that is about to be added
};

}  // namespace sunfleck::engine
