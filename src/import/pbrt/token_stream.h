// Tokens of a file and of all that it includes, as one sequence.
#pragma once

#include "import/pbrt/lexer.h"

#include <memory>
#include <vector>

namespace sunfleck::engine {

/// Included files are spliced in where they are pushed; a token's text lives until release().
class TokenStream {
public:
    /// @param outer  the stream whose Import made this one, or null: its files are open, too.
    explicit TokenStream(const TokenStream* outer = nullptr) : outer_(outer) {}

    /// Continues with this file, and returns to the present one after it.
    /// @param from  the statement that includes it.
    /// @throws Error if the file includes itself, or files are open more than 100 deep.
    void push(std::string text, const std::string& file, const SourceLocation& from);

    /// The next token, or nothing after the last one. @throws Error as Lexer::next() does.
    std::optional<Token> next();
    /// The same, left in place.
    const std::optional<Token>& peek();
    /// @throws Error, naming `what` was expected, at the end of the files.
    Token require(const std::string& what);
    /// The text of a string. @throws Error if the next token is none.
    std::string require_string(const std::string& what);
    /// @throws Error if the next token is no finite number.
    double require_number(const std::string& what);
    /// Checks before reading a file that push() would take it. @throws Error as push() does.
    void check_opening(const std::string& file, const SourceLocation& from) const;

    /// The file that all began with. Call it within a statement of an included file or before one
    /// is pushed.
    const Lexer& root() const { return outer_ ? outer_->root() : *open_.front(); }

    /// Drops files that have ended, and with them the text of their tokens.
    void release() { ended_.clear(); }

private:
    bool is_open(const std::string& file) const;
    std::size_t depth() const { return open_.size() + (outer_ ? outer_->depth() : 0); }

    const TokenStream* outer_;
    std::vector<std::unique_ptr<Lexer>> open_;
    std::vector<std::unique_ptr<Lexer>> ended_;
    std::optional<Token> peeked_;
    bool has_peeked_ = false;
    SourceLocation end_;  // of the last file
};

}  // namespace sunfleck::engine
