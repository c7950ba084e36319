// Relighting: changes the brightness of light groups (aovs/light_groups.h) in a rendered picture.
#pragma once

#include "image/picture.h"
#include "math/vector.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// The factor of a light group.
struct LightGroupFactor {
    std::string name;
    Vec3 rgb{1};  // not negative
};

struct Relit {
    Picture picture;
    std::vector<std::string> left_out;  // AOVs left out, because they are no longer valid
};

/// Returns RGB and the light groups with new brightness, and the feature AOVs (albedo, normal,
/// depth) and mattes unchanged. All other AOVs are left out, because they contain all lights. The
/// bias subtracted from `extrapolated` pictures is unchanged.
/// @param name  of the picture, for errors.
/// @throws Error  for a group that the picture does not have, or that is named twice.
Relit relit(const Picture& picture, const std::vector<LightGroupFactor>& factors,
            const std::string& name);

/// Returns the names of the picture's light groups, sorted.
std::vector<std::string> light_groups_of(const Picture& picture);

/// Returns R, G, B without the light of all groups: all light of a picture that has none.
/// @throws Error  for a picture that lacks one of the channels.
Picture rest_of_light(const Picture& picture);

}  // namespace sunfleck::engine
