// Errors of one method on one scene, over seeds.
#pragma once

#include "compare/spots.h"
#include "evenness/light.h"

namespace sunfleck::engine::bench {

/// Errors of one picture. Squared errors are those at the processor time asked for: they are
/// scaled by the time that was taken.
struct PictureErrors {
    /// By part: of all light against the reference, of an AOV around its mean over all seeds.
    std::array<std::array<ClassError, kClassCount>, kParts.size()> classes;
    double relative = 0;  // relative_square_error() of all light
    Spots spots;
    double brightness = 0;  // over the reference's
    double cpu_seconds = 0;
    double time_scale = 1;  // of that over what was asked for
};

/// A method on a scene: one entry a seed.
struct SceneErrors {
    std::vector<PictureErrors> pictures;

    /// Returns the root of the mean squared error of a class, over the class's mean brightness.
    double rms(std::size_t part, std::size_t number, double ClassError::*kind) const;
    /// Returns the mean of a number of each picture.
    double mean(double PictureErrors::*number) const;
};

/// @param renders  of one method, one a seed.
SceneErrors errors_of(const Reference& reference, const std::vector<Render>& renders);

}  // namespace sunfleck::engine::bench
