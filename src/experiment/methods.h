// The rendering methods that the paper compares, and others to compare with.
//
// All four samplers compute all light by photons, with 200,000 paths per pass, alpha 0.7 and an
// initial radius of two pixels for all photons, as in section 7 of the paper; they differ in the
// source of photon paths alone.
#pragma once

#include "experiment/cell.h"

namespace sunfleck::engine {

/// Returns one of the photon samplers "random", "uniform", "adaptive", "paper".
Method sampler_method(const std::string& name);

/// Returns all four in table order: random, uniform, paper, adaptive.
std::vector<Method> sampler_methods();

/// Returns Sunfleck without any flag.
Method default_method();

/// Returns an integrator: "path", "bdpt", "mlt" or "light".
Method integrator_method(const std::string& name);

/// Returns the sampler `paper` with additional flags.
Method paper_method(const std::string& name, const std::vector<std::string>& flags);

/// Returns how the reference of a scene is rendered: by a method that is not under test there, if
/// one converges.
Cell reference_cell(const std::string& scene, const RunSettings& settings);

}  // namespace sunfleck::engine
