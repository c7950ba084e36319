// Conversion of words to numbers by std::from_chars: fast, and deaf to the locale.
#include "import/pbrt/numbers.h"

#include "import/pbrt/words.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

/// from_chars takes no plus sign.
std::string_view without_plus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    return plus ? text.substr(1) : text;
}

/// How to write what was meant for a number.
std::string number_mend(const Token& token) {
    const std::string_view text = token.text;
    if (token.kind == TokenKind::string) return "write a number such as 1.5, without quotes";
    if (text.find(',') != std::string_view::npos || text.find(';') != std::string_view::npos)
        return "write numbers such as 1.5, with a point, and blanks between them";
    return "write a number such as 1.5";
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
    // Out of range: too large, or too close to zero, which is zero then.
    if (code == std::errc::result_out_of_range) {
        value = std::strtod(std::string(text).c_str(), nullptr);
        if (std::abs(value) < 1) return 0;
    }
    if (!(std::abs(value) <= double{std::numeric_limits<float>::max()}))
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
