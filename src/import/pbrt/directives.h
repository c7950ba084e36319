// The directives of the language, and where each of them may stand.
//
// In:  tokens. Out: the reading, changed by one statement after the other.
#pragma once

#include "import/pbrt/token_stream.h"

#include <span>

namespace sunfleck::engine {

struct Reading;

/// Reads one statement, whose first word is `keyword`.
using Handler = void (*)(Reading& reading, TokenStream& tokens, const Token& keyword);

enum class Place { anywhere, before_world, in_world };

struct Directive {
    std::string_view word;
    Place place;
    Handler handler;
};

/// By subject, each in a file of its own.
std::span<const Directive> transform_directives();
std::span<const Directive> block_directives();
std::span<const Directive> option_directives();
std::span<const Directive> world_directives();
std::span<const Directive> file_directives();

/// Reads all statements of a stream. @throws Error for what is no directive, or stands where it
/// may not.
void read_statements(Reading& reading, TokenStream& tokens);

}  // namespace sunfleck::engine
