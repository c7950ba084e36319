// Two sets of photons: where one is found in a cylinder of the first, those of the second are
// counted. So a cylinder of many photons does not vouch for itself.
#include "planning/direct_in_media_trial.h"

#include "photon_samplers/splitting_sampler.h"
#include "planning/trial_iterations.h"
#include "planning/way_tuning.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr auto kDirectInMedia =
    static_cast<std::uint8_t>(static_cast<unsigned>(PhotonKind::direct) << kKindsInMedia);

/// Visible points whose photons straight from lights are counted apart: cylinder i's as those of
/// pixel i + 1, all others as those of pixel 0.
struct CountedCylinders {
    VisiblePointLists points{1};
    std::vector<double> volumes;

    explicit CountedCylinders(std::span<const VisiblePoint> seen) {
        for (const VisiblePoint& point : seen) {
            if ((point.disc.kinds & kDirectInMedia) != 0) {
                const double radius = point.disc.radius_for(PhotonKind::direct);
                volumes.push_back(kPiDouble * radius * radius * 2 * point.disc.half_length);
                add(point, kDirectInMedia, volumes.size());
            }
            add(point, static_cast<std::uint8_t>(~kDirectInMedia), 0);
        }
    }

private:
    /// @param kinds  of the point's photons, at most.
    void add(VisiblePoint point, std::uint8_t kinds, std::size_t pixel) {
        point.disc.kinds &= kinds;
        point.pixel = static_cast<std::uint32_t>(pixel);
        if (point.disc.kinds != 0) points.front().push_back(point);
    }
};

/// Returns the part of the light samples in media that are lit, of those on rays next to one whose
/// sample is lit: so rays that pass no light do not count.
double lit_beside_lit(const PixelCells& cells, const std::vector<Lit>& lit) {
    double pairs = 0;
    double both = 0;
    const auto add = [&](Lit one, Lit other) {
        if (one == Lit::not_sampled || other == Lit::not_sampled) return;
        pairs += (one == Lit::lit ? 1 : 0) + (other == Lit::lit ? 1 : 0);
        both += one == Lit::lit && other == Lit::lit ? 2 : 0;
    };
    const auto at = [&](int x, int y) { return lit[cells.pixel_of(x, y)]; };
    for (int y = 0; y < cells.down(); ++y)
        for (int x = 0; x < cells.across(); ++x) {
            if (x + 1 < cells.across()) add(at(x, y), at(x + 1, y));
            if (y + 1 < cells.down()) add(at(x, y), at(x, y + 1));
        }
    return pairs > 0 ? both / pairs : 0;
}

}  // namespace

bool may_share_direct_light(const PassScene& pass, const TransportSettings& transport) {
    return transport.direct == DirectLight::sampled &&
           transport.indirect == IndirectLight::photons &&
           std::any_of(pass.media.begin(), pass.media.end(),
                       [](const SampledMedium& medium) { return medium.scatters; });
}

std::optional<DirectInMedia> learned_direct_in_media(const CameraPass& trial,
                                                     const CameraTrial& seen,
                                                     const std::vector<LightStratum>& plan,
                                                     const PilotName& name) {
    CountedCylinders counted(seen.index.points());
    const std::size_t cylinders = counted.volumes.size();
    if (cylinders == 0) return {};
    const VisiblePointIndex index(std::move(counted.points), trial.transport.max_depth);
    const std::uint64_t paths = paths_of(plan);
    const std::vector<LightStratum> strata = fraction_of(
        plan, static_cast<std::uint32_t>(std::max<std::uint64_t>(1, paths / kPathsOfASet)));
    const PhotonContext context{trial.scene, trial.transport, index};
    std::array<PhotonCounts, 2> met{PhotonCounts(cylinders + 1), PhotonCounts(cylinders + 1)};
    for (std::uint32_t set = 0; set < met.size(); ++set) {
        PassImage unused(cylinders + 1, {});
        NoState none;
        SplittingSampler::trace({context, name.iteration(kMediaSetsIteration + set), strata, {}},
                                {unused, &met.at(set)}, none);
    }
    double photons = 0;
    double volume = 0;
    for (std::size_t i = 0; i < cylinders; ++i)
        for (const auto& [one, other] : {std::pair(0, 1), std::pair(1, 0)}) {
            if (met.at(one)[i + 1] == 0) continue;
            photons += static_cast<double>(met.at(other)[i + 1]);
            volume += counted.volumes[i];
        }
    if (!(volume > 0)) return {};
    // One more: with so few that no two meet, photons still bring what light samples miss.
    const double in_a_pass = static_cast<double>(paths) / static_cast<double>(paths_of(strata));
    return DirectInMedia{static_cast<float>((photons + 1) / volume * in_a_pass),
                         static_cast<float>(lit_beside_lit({trial.window, seen.cells}, seen.lit))};
}

}  // namespace sunfleck::engine
