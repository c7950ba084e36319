// A check of numbers on the command line, for CLI11.
#pragma once

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <string>

namespace sunfleck::engine {

template <class Number>
CLI::Validator number_check(Number low, Number high, const char* kind) {
    return {[=](std::string& text) {
                Number value{};
                const auto [stop, fault] =
                    std::from_chars(text.data(), text.data() + text.size(), value);
                const bool is_number = fault == std::errc() && stop == text.data() + text.size();
                if (is_number && value >= low && value <= high) return std::string();
                return fmt::format("\"{}\" is no {} from {} to {}", text, kind, low, high);
            },
            fmt::format("{} to {}", low, high)};
}

/// A finite number within [low, high]. (CLI::Range lets pass what is not a number.)
inline CLI::Validator between(double low, double high) {
    return number_check(low, high, "number");
}

/// A whole number within [low, high].
inline CLI::Validator whole(std::int64_t low, std::int64_t high) {
    return number_check(low, high, "whole number");
}

}  // namespace sunfleck::engine
