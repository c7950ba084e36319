// A number does not silently become a spectrum that has it in every wavelength.
// Refused with: conversion from|could not convert|no viable conversion
#include "math/sampled_spectrum.h"

namespace sunfleck::engine {

SampledSpectrum albedo() {
#ifdef FAULT
    return 0.5F;
#else
    return SampledSpectrum(0.5F);
#endif
}

}  // namespace sunfleck::engine
