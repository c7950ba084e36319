// TextCursor: reads a text line by line and word by word, without copies, and tells places in it.
//
// Lines end in LF, CR or both. A backslash at the end of a line continues it; # begins a comment.
#pragma once

#include "sunfleck/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

class TextCursor {
public:
    /// @param name  of the text for messages; it and the text must outlive this.
    TextCursor(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    bool at_end() const { return at_ == text_.size(); }
    std::size_t offset() const { return at_; }
    /// @param offset  within the text, as offset() was.
    void move_to(std::size_t offset) { at_ = offset; }

    /// Skips blanks of the line. @return whether the line has nothing more, or a comment.
    bool at_line_end() {
        skip_blanks();
        return at_end() || is_line_end(text_[at_]) || text_[at_] == '#';
    }
    /// Skips what is left of the line, and its end.
    void next_line();
    /// Returns the next word of the line; empty at its end.
    std::string_view word();
    /// Returns the next word of the text, on this line or a later one; empty at its end.
    std::string_view word_of_text();
    /// Returns what is left of the line, without blanks around it; # is a character of it.
    std::string_view rest_of_line();

    /// Reads a number. One too large for a double is infinite; it may be NaN.
    /// @param what  completes the message: expected `what`.
    /// @throws Error  if the next word of the line is no number.
    double number(std::string_view what);
    /// Reads a number if the next word is one; else leaves the word.
    std::optional<double> find_number();

    /// Returns line and column of a byte; both count from 1. It counts the lines behind the byte
    /// that was asked for last, or all where that is farther on.
    SourceLocation location(std::size_t offset) const;
    SourceLocation location() const { return location(at_); }
    [[noreturn]] void fail(std::size_t offset, const std::string& what,
                           const std::string& mend) const {
        throw Error(location(offset), what, mend);
    }

private:
    static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

    void skip_blanks();

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
    struct Known {
        std::size_t offset = 0;
        int line = 1;
        int column = 1;
    };
    mutable Known known_;  // the location that was asked for last
};

/// Returns a word of text as a number, by the whole word, or nothing. It may be infinite or NaN,
/// also as Microsoft's library writes them (1.#INF, -1.#IND, 1.#QNAN).
std::optional<double> number_of(std::string_view word);

}  // namespace sunfleck::engine
