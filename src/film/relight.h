// Light changed after the render: a picture whose light groups hold the light of some lights apart
// (aovs/light_groups.h), with other brightness for these.
#pragma once

#include "image/picture.h"
#include "math/vector.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// What to multiply a light group by.
struct LightGroupFactor {
    std::string name;
    Vec3 rgb{1};  // not negative
};

struct Relit {
    Picture picture;
    std::vector<std::string> left_out;  // AOVs of the picture as it was, which no longer hold
};

/// RGB and the light groups as they would be; AOVs of features (albedo, normal, depth) as
/// they are. All other AOVs are left out: they are of all lights together. What `extrapolated`
/// pictures have lost as bias stays as it was.
/// @param name  of the picture, for errors.
/// @throws Error for a group that the picture does not have, or that is named twice.
Relit relit(const Picture& picture, const std::vector<LightGroupFactor>& factors,
            const std::string& name);

}  // namespace sunfleck::engine
