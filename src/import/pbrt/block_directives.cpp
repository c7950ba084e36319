// Blocks: attributes, objects and their instances, the world.
#include "import/pbrt/directives.h"
#include "import/pbrt/parameter_parser.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

namespace sunfleck::engine {
namespace {

constexpr std::size_t kDeepestBlock = 500;
constexpr std::size_t kMostDefaults = 1000;

void open(Reading& reading, const Token& keyword) {
    if (reading.blocks.size() >= kDeepestBlock)
        throw Error(keyword.where(), "blocks are nested more than 500 deep",
                    "check that each block is closed");
    reading.blocks.push_back({std::string(keyword.text), keyword.where(), reading.state});
}

/// Closes the innermost block, which must be an object or must not.
void close(Reading& reading, const Token& keyword, bool object) {
    const std::string word(keyword.text);
    if (reading.blocks.size() <= reading.block_base)
        throw Error(keyword.where(), word + " closes nothing", "remove it, or open its block");
    const Block& block = reading.blocks.back();
    if ((block.begin == "ObjectBegin") != object)
        throw Error(
            keyword.where(),
            word + " closes the " + block.begin + " of line " + std::to_string(block.where.line),
            "close that block by its own word first");
    reading.state = block.saved;
    reading.blocks.pop_back();
}

void attribute_begin(Reading& reading, TokenStream&, const Token& keyword) {
    open(reading, keyword);
}

void attribute_end(Reading& reading, TokenStream&, const Token& keyword) {
    close(reading, keyword, false);
}

void world_begin(Reading& reading, TokenStream&, const Token& keyword) {
    if (reading.in_world) throw Error(keyword.where(), "a second WorldBegin", "remove it");
    reading.in_world = true;
    reading.state.matrix = Motion();
    reading.state.active = {true, true};
    reading.coordinate_systems["world"] = Motion();
}

void object_begin(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of an object");
    if (reading.open_object)
        throw Error(keyword.where(), "ObjectBegin within an object",
                    "close the first one by ObjectEnd");
    const auto next = static_cast<std::uint32_t>(reading.scene.objects.size());
    if (!reading.objects.try_emplace(name, next).second)
        throw Error(keyword.where(), "a second object " + in_quotes(name), "give it another name");
    open(reading, keyword);
    reading.scene.objects.emplace_back();
    reading.open_object = next;
}

void object_end(Reading& reading, TokenStream&, const Token& keyword) {
    close(reading, keyword, true);
    reading.open_object.reset();
}

void object_instance(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of an object");
    if (reading.open_object)
        throw Error(keyword.where(), "ObjectInstance of " + in_quotes(name) + " within an object",
                    "objects hold shapes alone: write the shapes again");
    reading.instances.push_back({name, reading.still_matrix(keyword.where()), keyword.where()});
}

std::shared_ptr<const Parameters>* defaults_of(GraphicsState& state, const std::string& target) {
    if (target == "shape") return &state.shape_defaults;
    if (target == "light") return &state.light_defaults;
    if (target == "material") return &state.material_defaults;
    if (target == "medium") return &state.medium_defaults;
    if (target == "texture") return &state.texture_defaults;
    return nullptr;
}

void attribute(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    auto* defaults = defaults_of(reading.state, statement.type);
    if (!defaults)
        throw Error(statement.where, "Attribute of " + in_quotes(statement.type),
                    "use \"shape\", \"light\", \"material\", \"medium\" or \"texture\"");
    reading.defaults.insert(reading.defaults.end(), statement.own.begin(), statement.own.end());
    Parameters all = *defaults ? **defaults : Parameters();
    all.insert(all.end(), statement.own.begin(), statement.own.end());
    if (all.size() > kMostDefaults)
        throw Error(statement.where, "more than 1000 defaults by Attribute", "give fewer");
    *defaults = std::make_shared<const Parameters>(std::move(all));
}

constexpr std::array<Directive, 9> kDirectives = {
    {{"AttributeBegin", Place::in_world, attribute_begin},
     {"AttributeEnd", Place::in_world, attribute_end},
     {"TransformBegin", Place::in_world, attribute_begin},
     {"TransformEnd", Place::in_world, attribute_end},
     {"WorldBegin", Place::anywhere, world_begin},
     {"ObjectBegin", Place::in_world, object_begin},
     {"ObjectEnd", Place::in_world, object_end},
     {"ObjectInstance", Place::in_world, object_instance},
     {"Attribute", Place::anywhere, attribute}}};

}  // namespace

std::span<const Directive> block_directives() {
    return kDirectives;
}

}  // namespace sunfleck::engine
