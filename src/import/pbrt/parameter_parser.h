// Reads a list of parameters: "type name" value, or "type name" [ values ], any number of them.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/token_stream.h"

namespace sunfleck::engine {

/// All parameters that follow; ends before the next directive.
/// @param space  that rgb values are in.
/// @throws Error for unknown types, values of the wrong kind, lists that are cut or never end.
Parameters read_parameters(TokenStream& tokens, ColourSpace space = ColourSpace::srgb);

/// A type word and the parameters that follow. @param keyword  the directive.
Statement read_statement(TokenStream& tokens, const Token& keyword,
                         ColourSpace space = ColourSpace::srgb);

}  // namespace sunfleck::engine
