// What the sampler `paper` carries from pass to pass, beside the film.
//
// In:  settings, size of the picture. Out: a value that is all of it: a render goes on from a copy
// as if it had never stopped.
#pragma once

#include "film/film.h"
#include "paper/local_radii.h"
#include "photon/paper_chain.h"
#include "stages/settings.h"

#include <array>

namespace sunfleck::engine {

struct PaperMemory {
    /// @param pixels  of the window.
    PaperMemory(const RenderSettings& settings, std::size_t pixels)
        : chain(settings.photon.paper), radii(pixels, settings.alpha) {}

    /// As StoredSample::visit().
    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.passes, self.shown, self.theta_counted, self.floor_counted);
        PaperState::visit(self.chain, archive);
        LocalRadii::visit(self.radii, archive);
        for (auto& flux : self.flux) archive(flux);
    }
    /// Can it be of the passes of this film?
    bool is_sound(const Film& film) const {
        const std::size_t pixels = film.key().pixels();
        for (const FixedPoints& sums : flux)
            if (!sums.empty() && sums.size() != 3 * pixels) return false;
        return passes == film.pass_count() && shown >= 0 && std::isfinite(shown) &&
               std::isfinite(theta_counted) && chain.is_sound() && radii.is_sound(pixels);
    }

    std::uint64_t passes = 0;
    PaperState chain;
    LocalRadii radii;
    std::array<FixedPoints, kAovCount> flux;  // tau / (pi R^2 paths), before normalisation
    double shown = 0;                         // what flux was multiplied by after the last pass
    double theta_counted = 0;                 // in the film's statistics
    std::uint64_t floor_counted = 0;
};

}  // namespace sunfleck::engine
