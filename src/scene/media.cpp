// Which media there are to think of.
#include "scene/media.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

bool absorbs(const Spectrum& curve) {
    for (int nm = 360; nm <= 830; ++nm)
        if (curve(static_cast<float>(nm)) > 0) return true;
    return false;
}

}  // namespace

bool Media::absorb() const {
    return std::any_of(absorption.begin(), absorption.end(), absorbs);
}

}  // namespace sunfleck::engine
