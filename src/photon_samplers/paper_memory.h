// PaperMemory: state that the sampler `paper` carries from pass to pass, beside the film.
//
// In:  settings, size of the picture. Out: a value; a render continues from a copy as if it had
// not stopped.
#pragma once

#include "aovs/channels.h"
#include "core/exact_sum.h"
#include "photon/paper_chain.h"
#include "photon_samplers/local_radii.h"

#include <array>
#include <cmath>
#include <vector>

namespace sunfleck::engine {

struct PaperMemory {
    /// @param alpha  of the local radii. @param pixels  of the window.
    PaperMemory(const PhotonSettings& settings, double alpha, std::size_t pixels)
        : chain(settings.paper), radii(pixels, alpha) {}

    /// As StoredSample::visit().
    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.passes, self.shown, self.theta_counted, self.floor_counted);
        PaperState::visit(self.chain, archive);
        LocalRadii::visit(self.radii, archive);
        for (auto& flux : self.flux) archive(flux);
    }
    /// Returns whether it can be the state after so many passes of a picture of so many pixels.
    bool is_sound(std::size_t pixels, std::uint64_t after_passes) const {
        for (const std::vector<FixedPoint>& sums : flux)
            if (!sums.empty() && sums.size() != 3 * pixels) return false;
        return passes == after_passes && shown >= 0 && std::isfinite(shown) &&
               std::isfinite(theta_counted) && chain.is_sound() && radii.is_sound(pixels);
    }

    /// @return the mean factor on the first radii.
    double shrink(VisiblePointLists& points) const {
        radii.shrink(points);
        return radii.mean_factor();
    }

    std::uint64_t passes = 0;
    PaperState chain;
    LocalRadii radii;
    /// tau / (pi R^2 paths), before normalisation.
    std::array<std::vector<FixedPoint>, kAovCount> flux;
    double shown = 0;          // what flux was multiplied by after the last pass
    double theta_counted = 0;  // in the film's statistics
    std::uint64_t floor_counted = 0;
};

}  // namespace sunfleck::engine
