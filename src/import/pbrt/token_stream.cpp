// The stack of open files.
#include "import/pbrt/token_stream.h"

#include "import/pbrt/numbers.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck::engine {

constexpr std::size_t kDeepestInclude = 100;

void TokenStream::check_opening(const std::string& file, const SourceLocation& from) const {
    if (is_open(file))
        throw Error(from, in_quotes(file, 4096) + " includes itself", "break the cycle");
    if (depth() >= kDeepestInclude)
        throw Error(from, "files include each other more than 100 deep", "include fewer");
}

void TokenStream::push(std::string text, const std::string& file, const SourceLocation& from) {
    check_opening(file, from);
    open_.push_back(std::make_unique<Lexer>(std::move(text), file));
}

bool TokenStream::is_open(const std::string& file) const {
    const bool here = std::any_of(open_.begin(), open_.end(),
                                  [&](const auto& lexer) { return lexer->file() == file; });
    return here || (outer_ != nullptr && outer_->is_open(file));
}

std::optional<Token> TokenStream::next() {
    if (has_peeked_) {
        has_peeked_ = false;
        return peeked_;
    }
    while (!open_.empty()) {
        if (auto token = open_.back()->next()) return token;
        end_ = open_.back()->here();
        ended_.push_back(std::move(open_.back()));
        open_.pop_back();
    }
    return std::nullopt;
}

const std::optional<Token>& TokenStream::peek() {
    if (!has_peeked_) {
        peeked_ = next();
        has_peeked_ = true;
    }
    return peeked_;
}

Token TokenStream::require(const std::string& what) {
    if (const auto token = next()) return *token;
    throw Error(end_, "the file ends where " + what + " should follow",
                "complete it, or check that it was copied whole");
}

std::string TokenStream::require_string(const std::string& what) {
    const Token token = require(what);
    if (token.kind == TokenKind::string) return unescaped(token);
    throw Error(token.where(), "expected " + what + ", found " + in_quotes(token.text),
                "write it in quotes");
}

double TokenStream::require_number(const std::string& what) {
    return real_of(require(what));
}

}  // namespace sunfleck::engine
