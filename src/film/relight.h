// Light changed after the render: a picture whose aovs hold the light of some lights apart
// (aovs/light_groups.h), with other brightness for these.
#pragma once

#include "image/picture.h"
#include "math/vector.h"

#include <string>
#include <vector>

namespace sunfleck {

/// What to multiply a aov of lights by.
struct LightGroupFactor {
    std::string name;
    Vec3 rgb{1};  // not negative
};

struct Relit {
    Picture picture;
    std::vector<std::string> left_out;  // aovs of the picture as it was, which no longer hold
};

/// RGB and the aovs of lights as they would be; aovs of features (albedo, normal, depth) as
/// they are. All other aovs are left out: they are of all lights together. What `extrapolated`
/// pictures have lost as bias stays as it was.
/// @param name  of the picture, for errors.
/// @throws Error for a aov that the picture does not have, or that is named twice.
Relit relit(const Picture& picture, const std::vector<LightGroupFactor>& factors,
            const std::string& name);

}  // namespace sunfleck
