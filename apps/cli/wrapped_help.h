// The help of the program, in lines that fit a page.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace sunfleck::engine {

class WrappedHelp : public CLI::Formatter {
public:
    WrappedHelp() { label("SUBCOMMAND", "COMMAND"); }

    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override {
        std::string text = Formatter::make_help(app, std::move(name), mode);
        for (std::size_t at = 0; (at = text.find("\n\n\n")) != std::string::npos;)
            text.erase(at, 1);  // one empty line between groups
        return text;
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        constexpr std::size_t kPage = 100;
        const std::size_t width = kPage - get_column_width();
        std::string wrapped;
        std::size_t column = 0;
        std::istringstream words(option->get_description());
        for (std::string word; words >> word;) {
            const bool fits = column + 1 + word.size() <= width;
            if (column > 0) wrapped += fits ? ' ' : '\n';
            column = column > 0 && fits ? column + 1 + word.size() : word.size();
            wrapped += word;
        }
        return wrapped;
    }
};

}  // namespace sunfleck::engine
