// Words of a text; numbers by std::from_chars, which no locale changes.
#include "core/text_cursor.h"

#include "core/printable.h"

#include <charconv>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// A number beyond the range of doubles: zero or infinite, by the sign of its exponent.
double out_of_range(std::string_view word) {
    const std::size_t exponent = word.find_first_of("eE");
    const bool is_tiny = exponent == std::string_view::npos
                             ? word.find_first_of("123456789") > word.find('.')
                             : word.find('-', exponent) != std::string_view::npos;
    const double size = is_tiny ? 0 : HUGE_VAL;
    return word.starts_with('-') ? -size : size;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [behind, fault] = std::from_chars(word.data(), end, value);
    if (fault == std::errc() && behind == end) return value;
    if (fault == std::errc::result_out_of_range && behind == end) return out_of_range(word);
    if (fault != std::errc() || *behind != '#') return std::nullopt;
    const std::string_view kind(behind, static_cast<std::size_t>(end - behind));
    if (kind.starts_with("#INF")) return std::copysign(HUGE_VAL, value);
    if (kind.starts_with("#IND") || kind.starts_with("#QNAN") || kind.starts_with("#SNAN"))
        return std::nan("");
    return std::nullopt;
}

void TextCursor::skip_blanks() {
    while (at_ < text_.size()) {
        if (is_blank(text_[at_])) {
            ++at_;
            continue;
        }
        if (text_[at_] != '\\' || at_ + 1 == text_.size() || !is_line_end(text_[at_ + 1])) return;
        at_ += text_.substr(at_ + 1).starts_with("\r\n") ? 3 : 2;
    }
}

void TextCursor::next_line() {
    at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    if (at_end()) return;
    at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
}

std::string_view TextCursor::word() {
    if (at_line_end()) return {};
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && !is_line_end(text_[at_])) ++at_;
    // A backslash at the end of the line is no part of the word before it.
    if (at_ < text_.size() && is_line_end(text_[at_]) && text_[at_ - 1] == '\\' && at_ - begin > 1)
        --at_;
    return text_.substr(begin, at_ - begin);
}

std::string_view TextCursor::word_of_text() {
    std::string_view next = word();
    while (next.empty() && !at_end()) {
        next_line();
        next = word();
    }
    return next;
}

std::string_view TextCursor::rest_of_line() {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    std::string_view rest = text_.substr(at_, end - at_);
    at_ = end;
    while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
    return rest;
}

double TextCursor::number(std::string_view what) {
    if (at_line_end())
        fail(at_, "the line ends where " + std::string(what) + " is expected",
             "give all numbers of the statement");
    const std::size_t begin = at_;
    const std::string_view text = word();
    if (const auto value = number_of(text)) return *value;
    const bool has_comma = text.find(',') != std::string_view::npos;
    fail(begin, in_quotes(text, 40) + " is no number",
         has_comma ? "write a point in place of the comma" : "give " + std::string(what));
}

std::optional<double> TextCursor::find_number() {
    const std::size_t begin = at_;
    const auto value = number_of(word());
    if (!value) at_ = begin;
    return value;
}

SourceLocation TextCursor::location(std::size_t offset) const {
    const std::size_t end = std::min(offset, text_.size());
    if (end < known_.offset) known_ = {};
    for (; known_.offset < end; ++known_.offset) {
        const bool ends_in_cr =
            text_[known_.offset] == '\r' && text_.substr(known_.offset + 1, 1) != "\n";
        const bool ends = text_[known_.offset] == '\n' || ends_in_cr;
        known_.line += ends ? 1 : 0;
        known_.column = ends ? 1 : known_.column + 1;
    }
    return {name_, known_.line, known_.column};
}

}  // namespace sunfleck::engine
