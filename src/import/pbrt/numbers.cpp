// Conversion of words to numbers by std::from_chars, independent of the locale.
#include "import/pbrt/numbers.h"

#include "core/float_range.h"
#include "import/pbrt/words.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

/// Removes a plus sign, which from_chars does not accept.
std::string_view without_plus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    return plus ? text.substr(1) : text;
}

/// Returns how to write the number that was meant.
std::string number_mend(const Token& token) {
    const std::string_view text = token.text;
    if (token.kind == TokenKind::string) return "write a number such as 1.5, without quotes";
    if (text.find(',') != std::string_view::npos || text.find(';') != std::string_view::npos)
        return "write numbers such as 1.5, with a point, and blanks between them";
    return "write a number such as 1.5";
}

/// Of a number out of the range of doubles: is it too close to zero? Else it is too large.
bool is_near_zero(std::string_view text) {
    const std::size_t exponent = text.find_first_of("eE");
    if (exponent != std::string_view::npos) return text.substr(exponent + 1).starts_with('-');
    return text.find_first_of("123456789") > text.find('.');
}

}  // namespace

double real_of(const Token& token) {
    const std::string_view text = without_plus(token.text);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = end == text.data() + text.size() && !text.empty();
    if (token.kind != TokenKind::word || !whole || code == std::errc::invalid_argument)
        throw Error(token.where(), "expected a number, found " + in_quotes(token.text),
                    number_mend(token));
    if (code == std::errc::result_out_of_range) {
        if (is_near_zero(text)) return 0;
        value = std::numeric_limits<double>::infinity();
    }
    if (!is_finite_float(value))
        throw Error(token.where(), in_quotes(token.text) + " is not a finite float",
                    "use a number below 3.4e38");
    return value;
}

int integer_of(const Token& token) {
    const std::string_view text = without_plus(token.text);
    int value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (token.kind != TokenKind::word || code != std::errc() || end != text.data() + text.size())
        throw Error(token.where(), "expected an integer, found " + in_quotes(token.text),
                    token.kind == TokenKind::string ? "write a whole number, without quotes"
                                                    : "write a whole number of at most 2147483647");
    return value;
}

}  // namespace sunfleck::engine
