// A check of numbers on the command line, for CLI11.
#pragma once

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <string>

namespace sunfleck {

/// A finite number within [low, high]. (CLI::Range lets pass what is not a number.)
inline CLI::Validator between(double low, double high) {
    return {[=](std::string& text) {
                double value = 0;
                const auto [stop, fault] =
                    std::from_chars(text.data(), text.data() + text.size(), value);
                const bool is_number = fault == std::errc() && stop == text.data() + text.size();
                if (is_number && value >= low && value <= high) return std::string();
                return fmt::format("\"{}\" is no number between {} and {}", text, low, high);
            },
            fmt::format("{} to {}", low, high)};
}

}  // namespace sunfleck
