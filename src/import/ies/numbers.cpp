// Scanning of numbers, with their places.
#include "import/ies/numbers.h"

#include "core/text_cursor.h"

#include <charconv>
#include <cmath>

namespace sunfleck::engine {
namespace {

bool is_between_numbers(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',';
}

}  // namespace

double IesNumbers::next(const std::string& what) {
    while (at_ < text_.size() && is_between_numbers(text_[at_])) ++at_;
    last_ = at_;
    if (at_ == text_.size())
        refuse("the file ends where " + what + " is expected",
               "take it from its maker anew; it is cut short, or announces more than it has");
    std::size_t end = at_;
    while (end < text_.size() && !is_between_numbers(text_[end])) ++end;
    const std::string_view word = text_.substr(at_, end - at_);
    const std::size_t plus = word.starts_with('+') ? 1 : 0;
    double value = 0;
    const char* const stop = word.data() + word.size();
    const auto [rest, fault] = std::from_chars(word.data() + plus, stop, value);
    if (fault != std::errc() || rest != stop || !std::isfinite(value))
        refuse("\"" + std::string(word.substr(0, 40)) + "\" where " + what + " is expected",
               "correct the number");
    at_ = end;
    return value;
}

std::size_t IesNumbers::count(const std::string& what) {
    const double value = next(what);
    // Each number takes a digit and a separator.
    const auto most = static_cast<double>((text_.size() - at_ + 1) / 2);
    if (!(value >= 1) || value != std::floor(value)) refuse(what + " cannot be", "correct it");
    if (value > most) refuse("the file is too short for " + what, "take it from its maker anew");
    return static_cast<std::size_t>(value);
}

void IesNumbers::refuse(const std::string& what, const std::string& mend) const {
    throw Error(location(), what, mend);
}

SourceLocation IesNumbers::location() const {
    return TextCursor(text_, name_).location(last_);
}

}  // namespace sunfleck::engine
