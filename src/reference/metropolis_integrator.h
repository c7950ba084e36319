// Metropolis light transport over bidirectional path tracing, in the space of its numbers.
//
// The state of a chain is the numbers of a whole pair of subpaths (reference/path_pair.h); its
// target is what the pair brings to the film, over all points and wavelengths, but for emitters as
// the camera sees them: these are left to a ray a pixel. A pass by itself:
// a bootstrap of independent pairs, whose mean is the normalisation; short chains from some of
// them, drawn by what they bring. So drawn, each state of a chain has the right mean, the first one
// too: there is no start-up bias.
// Source: Kelemen, Szirmay-Kalos, Antal and Csonka, A Simple and Robust Mutation Strategy for the
// Metropolis Light Transport Algorithm (2002); starting states by resampling: Veach 1997, 11.3.
#pragma once

#include "reference/path_integrator.h"

namespace sunfleck::engine {

/// What a pass is made of.
struct MetropolisPlan {
    std::size_t bootstrap = 0;  // pairs
    std::size_t chains = 0;
    std::size_t steps = 0;  // of each chain
};

/// A step a pixel, and half as many pairs of the bootstrap.
MetropolisPlan metropolis_plan(std::size_t pixels);

/// Adds a pass to the total. @return the share of the bootstrap that brought light.
double trace_metropolis_chains(const ReferencePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck::engine
