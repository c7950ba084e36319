// Metropolis light transport on bidirectional path tracing, in primary sample space.
//
// The state of a chain is the primary sample of a pair of subpaths (reference/path_pair.h). Its
// target is the contribution of the pair to the film, over all points and wavelengths, except
// emitters seen directly, which one ray per pixel adds. A pass is independent: a bootstrap of
// independent pairs, whose mean is the normalisation; then short chains from some of them,
// resampled by their targets. Hence each state of a chain, including the first, has the right mean,
// without start-up bias.
// Source: Kelemen, Szirmay-Kalos, Antal and Csonka, A Simple and Robust Mutation Strategy for the
// Metropolis Light Transport Algorithm (2002); start by resampling: Veach 1997, 11.3.
// Equations: docs/method/references.md, eq. (37).
#pragma once

#include "reference/path_integrator.h"

namespace sunfleck::engine {

/// Numbers of samples of a pass.
struct MetropolisPlan {
    std::size_t bootstrap = 0;  // count of pairs
    std::size_t chains = 0;
    std::size_t steps = 0;  // per chain
};

/// Returns one step per pixel, and half as many bootstrap pairs.
MetropolisPlan metropolis_plan(std::size_t pixels);

/// Adds a pass to the total. @return the fraction of bootstrap pairs that contributed light.
double trace_metropolis_chains(const ReferencePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck::engine
