// The ways of rendering that the paper compares, and those that it is compared with.
//
// The four samplers take all light by photons, 200,000 paths a pass, alpha 0.7 and a first radius
// of two pixels for all photons, as the paper's section 7 has it: what differs is where photon
// paths come from.
#pragma once

#include "experiment/cell.h"

namespace sunfleck::engine {

/// One of the photon samplers "random", "uniform", "adaptive", "paper".
Method sampler_method(const std::string& name);

/// All four, in the order of tables: random, uniform, paper, adaptive.
std::vector<Method> sampler_methods();

/// Sunfleck as it comes, without any flag.
Method default_method();

/// "path", "bdpt", "mlt" or "light".
Method integrator_method(const std::string& name);

/// The sampler `paper` with flags of its own.
Method paper_method(const std::string& name, const std::vector<std::string>& flags);

/// How a scene's reference is made: by a method that is not under test there, where one converges.
Cell reference_cell(const std::string& scene, const RunSettings& settings);

}  // namespace sunfleck::engine
