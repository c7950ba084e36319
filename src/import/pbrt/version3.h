// Words that pbrt-v3 had and pbrt-v4 has not: a scene with one of them is to be converted whole.
#pragma once

#include "sunfleck/error.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Is it a directive, a type of parameter, or a parameter, that only pbrt-v3 or older ones have?
bool is_directive_of_v3(std::string_view word);
bool is_parameter_type_of_v3(std::string_view word);
bool is_parameter_of_v3(std::string_view name);

/// @throws Error if only pbrt-v3 has that type for the directive: Film "image".
void check_not_of_v3(std::string_view directive, std::string_view type,
                     const SourceLocation& where);

/// @param what  the user's words. @throws Error, always.
[[noreturn]] void refuse_v3(const std::string& what, const SourceLocation& where);

}  // namespace sunfleck::engine
