// Include, which splices a file in, and Import, which keeps the file's state to itself.
#include "core/file_content.h"
#include "import/pbrt/directives.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

#include <array>

namespace sunfleck::engine {
namespace {

/// Reads the file that a statement names, and puts it in front of the stream.
/// @param to  where it goes: `tokens` itself, or a stream of its own.
void open(Reading& reading, TokenStream& tokens, const Token& keyword, TokenStream& to) {
    const std::string name = tokens.require_string("the name of a file");
    const SourceLocation from = keyword.where();
    to.check_opening(reading.assets.files.path_of(name), from);
    NamedFile file = reading.assets.files.read(name, from);
    if (!file.bytes.empty()) refuse_other_content(file.bytes, file.path, "a scene of pbrt-v4");
    reading.inclusions.add(file.path, from, to.root(),
                           [&](const std::string& other, const SourceLocation& where) {
                               return reading.assets.files.find(other, where);
                           });
    to.push(std::move(file.bytes), file.path, from);
}

void include(Reading& reading, TokenStream& tokens, const Token& keyword) {
    open(reading, tokens, keyword, tokens);
}

void import(Reading& reading, TokenStream& tokens, const Token& keyword) {
    TokenStream imported(&tokens);
    open(reading, tokens, keyword, imported);

    const GraphicsState before = reading.state;
    const auto systems = reading.coordinate_systems;
    const std::size_t base = reading.block_base;
    reading.block_base = reading.blocks.size();
    read_statements(reading, imported);
    reading.check_blocks_closed(reading.block_base);
    reading.block_base = base;
    reading.state = before;
    reading.coordinate_systems = systems;
}

constexpr std::array<Directive, 2> kDirectives = {
    {{"Include", Place::anywhere, include}, {"Import", Place::in_world, import}}};

}  // namespace

std::span<const Directive> file_directives() {
    return kDirectives;
}

}  // namespace sunfleck::engine
