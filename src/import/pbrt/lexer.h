// Cuts the text of a scene file into tokens: words, quoted strings, brackets.
//
// In:  bytes, perhaps behind a byte order mark. Out: tokens with line and column; comments (# to
//      the end of the line) are skipped. Lines end in LF, CR LF or CR.
#pragma once

#include "sunfleck/error.h"

#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

enum class TokenKind { word, string, open, close };

/// A view into the lexer's text; numbers are words. Columns count bytes.
struct Token {
    TokenKind kind = TokenKind::word;
    std::string_view text;  // of a string: what stands between the quotes, as written
    const std::string* file = nullptr;
    int line = 0;
    int column = 0;

    SourceLocation where() const { return {*file, line, column}; }
};

/// The text of a string token with its escapes (\n \t \\ \" and the like) undone. A backslash
/// before any other letter stays: it may be that of a file's name.
std::string unescaped(const Token& token);

class Lexer {
public:
    Lexer(std::string text, std::string file);
    Lexer(const Lexer&) = delete;
    Lexer& operator=(const Lexer&) = delete;
    Lexer(Lexer&&) = delete;
    Lexer& operator=(Lexer&&) = delete;
    ~Lexer() = default;

    /// The next token, or nothing at the end; its text lives as long as the lexer.
    /// @throws Error for a string without its closing quote, a word with a character that no word
    ///         has, or a token of more than 64 KiB.
    std::optional<Token> next();

    const std::string& file() const { return file_; }
    const std::string& text() const { return text_; }
    /// Where the next token would begin.
    SourceLocation here() const { return {file_, line_, column()}; }

private:
    void skip_space();
    Token string();
    Token word();
    Token token(TokenKind kind, std::size_t begin, std::size_t length) const;
    int column() const { return static_cast<int>(position_ - line_begin_) + 1; }

    std::string text_;
    std::string file_;
    std::size_t position_ = 0;
    std::size_t line_begin_ = 0;
    int line_ = 1;
};

}  // namespace sunfleck::engine
