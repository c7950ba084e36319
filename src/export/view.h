// Camera, film, filter and integrator as pbrt-v4 statements: what stands before WorldBegin.
#pragma once

#include "scene/description.h"

#include <string>

namespace sunfleck::engine {

/// Returns the statement of a camera in the world, with its frame. @param around  MediumInterface,
/// or empty. @param where  the scene, for warnings.
std::string camera_text(const Camera& camera, const std::string& around,
                        const SourceLocation& where, Warnings& warnings);

/// @param picture  name of the picture's file.
std::string film_text(const FilmDescription& film, const std::string& picture);

std::string filter_text(const FilterSettings& filter);

/// Returns integrator and sampler: those that the scene asks for, else photon mapping, or path
/// tracing where media absorb.
std::string integrator_text(const SceneDescription& scene);

}  // namespace sunfleck::engine
