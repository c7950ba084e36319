// Lookup of the media that matter.
#include "scene/media.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

bool is_anywhere(const Spectrum& curve) {
    for (int nm = 360; nm <= 830; ++nm)
        if (curve(static_cast<float>(nm)) > 0) return true;
    return false;
}

}  // namespace

bool acts(const Medium& medium) {
    return is_anywhere(medium.absorption) || is_anywhere(medium.scattering);
}

bool emits(const Medium& medium) {
    return medium.glow && is_anywhere(medium.glow->radiance) && is_anywhere(medium.absorption);
}

bool Media::act() const {
    return std::any_of(all.begin(), all.end(), acts);
}

}  // namespace sunfleck::engine
