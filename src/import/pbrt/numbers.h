// Numbers of a scene file: from words to finite values.
#pragma once

#include "import/pbrt/lexer.h"

namespace sunfleck::engine {

/// @throws Error for what is no number, NaN, infinite, or beyond the range of a float.
double real_of(const Token& token);

/// @throws Error for what is no integer of 32 bits.
int integer_of(const Token& token);

}  // namespace sunfleck::engine
