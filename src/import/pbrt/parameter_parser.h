// Parser of parameter lists: "type name" value, or "type name" [ values ], any number of them.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/token_stream.h"

namespace sunfleck::engine {

/// Reads all parameters up to the next directive.
/// @param space  colour space of rgb values.
/// @throws Error  for unknown types, values of the wrong kind, and lists that are not closed.
Parameters read_parameters(TokenStream& tokens, ColourSpace space = ColourSpace::srgb);

/// Reads a type word and the parameters that follow. @param keyword  the directive.
Statement read_statement(TokenStream& tokens, const Token& keyword,
                         ColourSpace space = ColourSpace::srgb);

}  // namespace sunfleck::engine
