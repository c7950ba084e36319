// Tokens of the pbrt-v4 language.
#include "import/pbrt/lexer.h"

#include "core/file_content.h"
#include "import/pbrt/odd_characters.h"

namespace sunfleck::engine {
namespace {

constexpr std::size_t kLongestToken = 65536;

bool is_space(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

bool ends_word(char c) {
    return is_space(c) || c == '"' || c == '[' || c == ']' || c == '#';
}

char escaped(char c) {
    constexpr std::string_view kLetters = "nrtbf\\'\"";
    constexpr std::string_view kMeanings = "\n\r\t\b\f\\'\"";
    const std::size_t at = kLetters.find(c);
    return at == std::string_view::npos ? '\0' : kMeanings[at];
}

}  // namespace

std::string unescaped(const Token& token) {
    if (token.text.find('\\') == std::string_view::npos) return std::string(token.text);
    std::string result;
    for (std::size_t i = 0; i < token.text.size(); ++i) {
        if (token.text[i] != '\\') {
            result += token.text[i];
            continue;
        }
        const char c = ++i < token.text.size() ? escaped(token.text[i]) : '\0';
        result += c == '\0' ? '\\' : c;
        if (c == '\0' && i < token.text.size()) result += token.text[i];
    }
    return result;
}

Lexer::Lexer(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {
    position_ = line_begin_ = text_.size() - without_mark(text_).size();
}

std::optional<Token> Lexer::next() {
    skip_space();
    if (position_ == text_.size()) return std::nullopt;
    const char c = text_[position_];
    if (c == '"') return string();
    if (c != '[' && c != ']') return word();
    const Token bracket = token(c == '[' ? TokenKind::open : TokenKind::close, position_, 1);
    ++position_;
    return bracket;
}

void Lexer::skip_space() {
    while (position_ < text_.size()) {
        const char c = text_[position_];
        if (c == '#') {
            const std::size_t end = text_.find_first_of("\n\r", position_);
            position_ = end == std::string::npos ? text_.size() : end;
            continue;
        }
        if (!is_space(c)) return;
        ++position_;
        const bool alone = position_ == text_.size() || text_[position_] != '\n';
        if (c != '\n' && !(c == '\r' && alone)) continue;
        ++line_;
        line_begin_ = position_;
    }
}

Token Lexer::token(TokenKind kind, std::size_t begin, std::size_t length) const {
    const Token result{kind, std::string_view(text_).substr(begin, length), &file_, line_,
                       column()};
    if (length > kLongestToken)
        throw Error(result.where(), "a token of " + std::to_string(length) + " bytes",
                    "at most 65536 are read");
    return result;
}

Token Lexer::string() {
    std::size_t end = position_ + 1;
    while (end < text_.size() && text_[end] != '"' && text_[end] != '\n')
        end += text_[end] == '\\' && end + 1 < text_.size() && text_[end + 1] != '\n' ? 2 : 1;
    if (end >= text_.size() || text_[end] != '"')
        throw Error(here(), "a string has no closing quote on its line", "close it with \"");
    const Token result = token(TokenKind::string, position_ + 1, end - position_ - 1);
    position_ = end + 1;
    return result;
}

Token Lexer::word() {
    std::size_t end = position_;
    bool is_odd = false;
    for (; end < text_.size() && (end == position_ || !ends_word(text_[end])); ++end)
        is_odd = is_odd || !is_plain(text_[end]);
    const Token result = token(TokenKind::word, position_, end - position_);
    if (is_odd) {
        const auto odd = *odd_character_in(result.text);
        position_ += odd.at;
        throw Error(here(), odd.what + " stands here, which no word has", odd.mend);
    }
    position_ = end;
    return result;
}

}  // namespace sunfleck::engine
