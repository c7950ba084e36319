// Parser of parameter lists: "type name" value, or "type name" [ values ], any number of them.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/token_stream.h"

namespace sunfleck::engine {

/// Returns a parameter without values from its declaration: type, blanks, name.
/// @param space  colour space of rgb values.
/// @throws Error  for unknown types, and for what only pbrt-v3 declares.
Parameter declared_parameter(const std::string& declaration, const SourceLocation& where,
                             ColourSpace space = ColourSpace::srgb);

/// @throws Error  if the numbers of a parameter do not form whole points, colours ...
void check_components(const Parameter& parameter);

/// Reads all parameters up to the next directive.
/// @param space  colour space of rgb values.
/// @throws Error  for unknown types, values of the wrong kind, and lists that are not closed.
Parameters read_parameters(TokenStream& tokens, ColourSpace space = ColourSpace::srgb);

/// Reads a type word and the parameters that follow. @param keyword  the directive.
Statement read_statement(TokenStream& tokens, const Token& keyword,
                         ColourSpace space = ColourSpace::srgb);

}  // namespace sunfleck::engine
