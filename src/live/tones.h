// Tone curves as a page has them: a table in place of the function.
#pragma once

#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Returns the curve of that name, or `none`, as JSON: the matrices `in` and `out` by rows, the
/// power `decoding`, and `values`: the value of the curve for each positive number of 16 bits (the
/// upper half of a float), by those bits.
std::string tone_json(std::string_view name);

}  // namespace sunfleck::engine
