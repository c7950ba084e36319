// Parameter lists, with the values that each type needs.
#include "import/pbrt/parameter_parser.h"

#include "import/pbrt/numbers.h"
#include "import/pbrt/odd_characters.h"
#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"

namespace sunfleck::engine {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

std::string text_of(const Token& token, const Parameter& parameter) {
    if (token.kind != TokenKind::string)
        throw Error(
            token.where(),
            "expected a string for " + parameter.title() + ", found " + in_quotes(token.text),
            "write it in quotes");
    return unescaped(token);
}

int flag_of(const Token& token, const Parameter& parameter) {
    if (token.text == "true") return 1;
    if (token.text == "false") return 0;
    throw Error(
        token.where(),
        "expected true or false for " + parameter.title() + ", found " + in_quotes(token.text),
        "write true or false");
}

void add_value(Parameter& parameter, const Token& token) {
    switch (parameter.type) {
        case ParameterType::boolean:
            parameter.integers.push_back(flag_of(token, parameter));
            break;
        case ParameterType::integer:
            parameter.integers.push_back(integer_of(token));
            break;
        case ParameterType::text:
        case ParameterType::texture:
            parameter.texts.push_back(text_of(token, parameter));
            break;
        case ParameterType::spectrum:
            if (token.kind == TokenKind::string)
                parameter.texts.push_back(unescaped(token));
            else
                parameter.numbers.push_back(real_of(token));
            break;
        default:
            parameter.numbers.push_back(real_of(token));
    }
}

void read_values(TokenStream& tokens, Parameter& parameter) {
    const std::string what = "a value of " + parameter.title();
    Token token = tokens.require(what);
    if (token.kind == TokenKind::close)
        throw Error(token.where(), "expected " + what + ", found \"]\"", "give the value");
    if (token.kind != TokenKind::open) return add_value(parameter, token);
    for (token = tokens.require(what + " or ]"); token.kind != TokenKind::close;
         token = tokens.require(what + " or ]")) {
        if (token.kind == TokenKind::open)
            throw Error(token.where(), "a list within the list of " + parameter.title(),
                        "close the first list with ]");
        add_value(parameter, token);
    }
}

}  // namespace

Parameter declared_parameter(const std::string& declaration, const SourceLocation& where,
                             ColourSpace space) {
    const std::string_view text = trimmed(declaration);
    if (const auto odd = odd_character_in(declaration))
        throw Error(where,
                    "unexpected " + odd->what + " in the declaration " + in_quotes(declaration),
                    odd->mend);
    const std::size_t blank = text.find_first_of(" \t");
    if (blank == std::string_view::npos)
        throw Error(where, "expected a parameter, found " + in_quotes(declaration),
                    "write its type and name, such as \"float radius\"");
    const auto type = parameter_type(text.substr(0, blank));
    const std::string_view name = trimmed(text.substr(blank));
    if (is_parameter_type_of_v3(text.substr(0, blank)) || is_parameter_of_v3(name))
        refuse_v3("the parameter " + in_quotes(declaration), where);
    if (!type)
        throw Error(where, "unknown parameter type in " + in_quotes(declaration),
                    "use float, integer, bool, string, point2, point3, vector3, normal, rgb, "
                    "spectrum, blackbody or texture");
    Parameter parameter;
    parameter.type = *type;
    parameter.name = name;
    parameter.where = where;
    parameter.space = space;
    return parameter;
}

void check_components(const Parameter& parameter) {
    const std::size_t components = components_of(parameter.type);
    if (components == 0 || parameter.numbers.size() % components == 0) return;
    throw Error(parameter.where,
                "parameter " + parameter.title() + " has " +
                    std::to_string(parameter.numbers.size()) + " numbers",
                "give a multiple of " + std::to_string(components));
}

Parameters read_parameters(TokenStream& tokens, ColourSpace space) {
    Parameters list;
    while (tokens.peek() && tokens.peek()->kind == TokenKind::string) {
        const Token token = *tokens.next();
        Parameter parameter = declared_parameter(unescaped(token), token.where(), space);
        read_values(tokens, parameter);
        check_components(parameter);
        list.push_back(std::make_shared<const Parameter>(std::move(parameter)));
    }
    return list;
}

Statement read_statement(TokenStream& tokens, const Token& keyword, ColourSpace space) {
    Statement statement;
    statement.keyword = keyword.text;
    statement.where = keyword.where();
    statement.type = tokens.require_string("the type of " + statement.keyword);
    check_not_of_v3(statement.keyword, statement.type, statement.where);
    statement.own = read_parameters(tokens, space);
    return statement;
}

}  // namespace sunfleck::engine
