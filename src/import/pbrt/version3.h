// Words that pbrt-v3 has and pbrt-v4 has not; scenes with one of them must be converted.
#pragma once

#include "sunfleck/error.h"

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Returns whether only pbrt-v3 or older has the directive, parameter type, or parameter.
bool is_directive_of_v3(std::string_view word);
bool is_parameter_type_of_v3(std::string_view word);
bool is_parameter_of_v3(std::string_view name);

/// @throws Error  if only pbrt-v3 has that type of the directive: Film "image".
void check_not_of_v3(std::string_view directive, std::string_view type,
                     const SourceLocation& where);

/// @param what  the user's words. @throws Error  always.
[[noreturn]] void refuse_v3(const std::string& what, const SourceLocation& where);

}  // namespace sunfleck::engine
