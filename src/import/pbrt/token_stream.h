// TokenStream: tokens of a file and of all files that it includes, as one sequence.
#pragma once

#include "import/pbrt/lexer.h"

#include <memory>
#include <vector>

namespace sunfleck::engine {

/// Included files are inserted where they are pushed; a token's text lives until release().
class TokenStream {
public:
    /// @param outer  stream whose Import made this one, or null: its files are open, too.
    explicit TokenStream(const TokenStream* outer = nullptr) : outer_(outer) {}

    /// Continues with this file, and returns to the current one after it.
    /// @param from  statement that includes it.
    /// @throws Error  if the file includes itself, or if more than 100 files are open.
    void push(std::string text, const std::string& file, const SourceLocation& from);

    /// Returns the next token, or nothing after the last one. @throws Error  as Lexer::next().
    std::optional<Token> next();
    /// Returns the next token without consuming it.
    const std::optional<Token>& peek();
    /// @throws Error  at the end of the files; it tells that `what` was expected.
    Token require(const std::string& what);
    /// Returns the text of a string. @throws Error  if the next token is not a string.
    std::string require_string(const std::string& what);
    /// @throws Error  if the next token is not a finite number.
    double require_number(const std::string& what);
    /// Checks before a file is read that push() would accept it. @throws Error  as push().
    void check_opening(const std::string& file, const SourceLocation& from) const;

    /// Returns the main file. It must be called within a statement of an included file, or before
    /// one is pushed.
    const Lexer& root() const { return outer_ ? outer_->root() : *open_.front(); }

    /// Releases files that have ended, and with them the text of their tokens.
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
