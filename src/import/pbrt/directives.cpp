// The loop over statements.
#include "import/pbrt/directives.h"

#include "import/pbrt/reading.h"
#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"

#include <map>

namespace sunfleck::engine {
namespace {

using Table = std::map<std::string_view, Directive>;

const Table& table() {
    static const Table table = [] {
        Table all;
        for (const auto part : {transform_directives(), block_directives(), option_directives(),
                                world_directives(), file_directives()})
            for (const Directive& directive : part) all.emplace(directive.word, directive);
        return all;
    }();
    return table;
}

[[noreturn]] void unknown(const Token& token) {
    if (token.kind == TokenKind::string)
        throw Error(token.where(),
                    "expected a directive, found the string " + in_quotes(token.text),
                    "the parameters of a statement come after its type");
    if (token.kind != TokenKind::word)
        throw Error(token.where(), "expected a directive, found " + in_quotes(token.text),
                    "remove the bracket, or open its list");
    if (is_directive_of_v3(token.text)) refuse_v3(std::string(token.text), token.where());
    if (token.text.starts_with("//") || token.text.starts_with("/*"))
        throw Error(token.where(), in_quotes(token.text) + " begins no comment", "write #");
    std::vector<std::string_view> words;
    for (const auto& [word, directive] : table()) words.push_back(word);
    throw Error(token.where(), "unknown directive " + in_quotes(token.text),
                did_you_mean(words, token.text));
}

void check_place(const Directive& directive, const Reading& reading, const Token& token) {
    if (directive.place == Place::before_world && reading.in_world)
        throw Error(token.where(), std::string(directive.word) + " stands after WorldBegin",
                    "move it before WorldBegin");
    if (directive.place == Place::in_world && !reading.in_world)
        throw Error(token.where(), std::string(directive.word) + " stands before WorldBegin",
                    "move it after WorldBegin");
}

}  // namespace

void read_statements(Reading& reading, TokenStream& tokens) {
    while (const auto token = tokens.next()) {
        const auto found =
            token->kind == TokenKind::word ? table().find(token->text) : table().end();
        if (found == table().end()) unknown(*token);
        check_place(found->second, reading, *token);
        reading.log.count_word("Directive", token->text);
        try {
            found->second.handler(reading, tokens, *token);
        } catch (const MissingFile& missing) {  // the statement is read to its end
            reading.assets.files.note_missing(missing);
        }
        tokens.release();
    }
}

}  // namespace sunfleck::engine
