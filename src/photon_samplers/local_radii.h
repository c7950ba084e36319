// Radii that shrink where photons arrive: the shared local statistics of each pixel.
//
// N' = N + alpha M, R'^2 = R^2 (N + alpha M) / (N + M) for M new photons. R is kept as a factor of
// the first radius of the pixel's visible point, which may be another one in each pass. The flux
// tau of the source needs no place of its own: tau / R^2 is the sum of the passes' flux / R^2.
// Source: Hachisuka and Jensen 2009, "Stochastic Progressive Photon Mapping", section 4.
#pragma once

#include "estimate/photon_counts.h"
#include "visible_points/visible_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunfleck::engine {

class LocalRadii {
public:
    LocalRadii(std::size_t pixels, double alpha)
        : alpha_(alpha), photons_(pixels, 0), factors_(pixels, 1) {}

    /// @param points  with their first radii.
    void shrink(VisiblePointLists& lists) const {
        for (std::vector<VisiblePoint>& points : lists)
            for (VisiblePoint& point : points)
                point.disc.radius *= static_cast<float>(factors_[point.pixel]);
    }

    /// @param taken  of this pass.
    void add(const PhotonCounts& taken) {
        for (std::size_t i = 0; i < photons_.size(); ++i) {
            const auto m = static_cast<double>(taken[i].load(std::memory_order_relaxed));
            if (m == 0) continue;
            const double kept = photons_[i] + alpha_ * m;
            factors_[i] *= std::sqrt(kept / (photons_[i] + m));
            photons_[i] = kept;
        }
    }

    /// As StoredSample::visit().
    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.alpha_, self.photons_, self.factors_);
    }
    bool is_sound(std::size_t pixels) const {
        const auto in_range = [](double photons) { return photons >= 0 && std::isfinite(photons); };
        const auto is_factor = [](double factor) { return factor > 0 && factor <= 1; };
        return alpha_ > 0 && alpha_ < 1 && photons_.size() == pixels && factors_.size() == pixels &&
               std::all_of(photons_.begin(), photons_.end(), in_range) &&
               std::all_of(factors_.begin(), factors_.end(), is_factor);
    }

    /// Of R over the first radius.
    double mean_factor() const {
        double sum = 0;
        for (const double factor : factors_) sum += factor;
        return sum / static_cast<double>(factors_.size());
    }

private:
    double alpha_;
    std::vector<double> photons_;  // N
    std::vector<double> factors_;
};

}  // namespace sunfleck::engine
