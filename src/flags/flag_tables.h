// The flags of a render in tables, by what they are about.
#pragma once

#include "flags/flag.h"

namespace sunfleck::engine {

/// When a render ends: passes, time, error.
std::vector<RenderFlag> end_flags();
/// What the picture shows: size, crop, exposure, AOVs, and whether bias is subtracted.
std::vector<RenderFlag> picture_flags();
/// How picture files are made of light, and how they are stored.
std::vector<RenderFlag> file_flags();
/// Which light paths there are, with every integrator.
std::vector<RenderFlag> transport_flags();
/// Integrator, photon sampler, gather radii. --photon-sampler stands before the flags that change
/// what a sampler prescribes.
std::vector<RenderFlag> method_flags();
/// Parts of the sampler `adaptive`, each of which can be left out.
std::vector<RenderFlag> adaptive_flags();
/// What the experiments of the paper's authors vary, with the sampler `paper`.
std::vector<RenderFlag> paper_flags();
/// Random numbers and instructions.
std::vector<RenderFlag> run_flags();

}  // namespace sunfleck::engine
