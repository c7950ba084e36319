// Directives of the world: materials, textures, media, lights, shapes.
#include "import/pbrt/directives.h"
#include "import/pbrt/lights.h"
#include "import/pbrt/parameter_parser.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/shapes.h"
#include "import/pbrt/words.h"

namespace sunfleck::engine {
namespace {

void material(Reading& reading, TokenStream& tokens, const Token& keyword) {
    Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    statement.defaults = reading.state.material_defaults;
    reading.state.material = reading.materials.add(std::move(statement));
}

void make_named_material(Reading& reading, TokenStream& tokens, const Token& keyword) {
    Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    statement.defaults = reading.state.material_defaults;
    const std::string name = statement.type;
    reading.materials.make(name, std::move(statement));
}

void named_material(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of a material");
    reading.state.material = reading.materials.slot_of(name, keyword.where());
}

void texture(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of a texture");
    const std::string kind = tokens.require_string("\"float\" or \"spectrum\"");
    Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    statement.defaults = reading.state.texture_defaults;
    reading.assets.textures.add(kind, name, std::move(statement),
                                reading.still_matrix(keyword.where()));
}

void make_named_medium(Reading& reading, TokenStream& tokens, const Token& keyword) {
    Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    statement.defaults = reading.state.medium_defaults;
    const auto type = statement.text("type");
    const bool is_even = !type || type == "homogeneous";  // then, its matrix says nothing
    const Matrix to_world = is_even ? Matrix() : reading.still_matrix(keyword.where());
    reading.media.make(std::move(statement), to_world);
}

/// Reads one name for both sides, or two; empty names are empty space.
void medium_interface(Reading& reading, TokenStream& tokens, const Token&) {
    GraphicsState& state = reading.state;
    state.inside_medium = tokens.require_string("the name of a medium");
    state.outside_medium = state.inside_medium;
    if (tokens.peek() && tokens.peek()->kind == TokenKind::string)
        state.outside_medium = tokens.require_string("the name of a medium");
}

void light_source(Reading& reading, TokenStream& tokens, const Token& keyword) {
    Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    statement.defaults = reading.state.light_defaults;
    add_light(statement, reading);
}

void area_light_source(Reading& reading, TokenStream& tokens, const Token& keyword) {
    Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    statement.defaults = reading.state.light_defaults;
    AreaEmission emission = area_emission(statement, reading);
    emission.statement = note_light(statement, reading);
    reading.state.emission = std::make_shared<const AreaEmission>(std::move(emission));
}

void shape(Reading& reading, TokenStream& tokens, const Token& keyword) {
    Statement statement = read_statement(tokens, keyword, reading.state.colour_space);
    statement.defaults = reading.state.shape_defaults;
    add_shape(statement, reading);
}

constexpr std::array<Directive, 9> kDirectives = {
    {{"Material", Place::in_world, material},
     {"MakeNamedMaterial", Place::in_world, make_named_material},
     {"NamedMaterial", Place::in_world, named_material},
     {"Texture", Place::in_world, texture},
     {"MakeNamedMedium", Place::anywhere, make_named_medium},
     {"MediumInterface", Place::anywhere, medium_interface},
     {"LightSource", Place::in_world, light_source},
     {"AreaLightSource", Place::in_world, area_light_source},
     {"Shape", Place::in_world, shape}}};

}  // namespace

std::span<const Directive> world_directives() {
    return kDirectives;
}

}  // namespace sunfleck::engine
