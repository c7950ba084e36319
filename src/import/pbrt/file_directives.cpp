// Include, which splices a file in, and Import, which keeps the file's state to itself.
#include "import/pbrt/directives.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

#include <array>

namespace sunfleck {
namespace {

void include(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of a file");
    const std::string path = resolved(name, reading.folder);
    tokens.check_opening(path, keyword.where());
    tokens.push(reading.read_file(name, keyword.where()), path, keyword.where());
}

void import(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of a file");
    const std::string path = resolved(name, reading.folder);
    TokenStream imported(&tokens);
    imported.check_opening(path, keyword.where());
    imported.push(reading.read_file(name, keyword.where()), path, keyword.where());

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

}  // namespace sunfleck
