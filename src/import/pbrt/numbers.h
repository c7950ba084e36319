// Numbers of a scene file: conversion of words to finite values.
#pragma once

#include "import/pbrt/lexer.h"

namespace sunfleck::engine {

/// @throws Error  for invalid numbers, NaN, infinity, and numbers beyond the range of floats.
double real_of(const Token& token);

/// @throws Error  for anything else than a 32-bit integer.
int integer_of(const Token& token);

}  // namespace sunfleck::engine
