// Man pages in roff, by the macros of man(7).
#include "apps/cli/man_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace sunfleck::engine {
namespace {

const char* const kExitCodes =
    ".SH EXIT STATUS\n"
    ".TP\n0\nDone.\n"
    ".TP\n1\nA fault of the program or of the machine.\n"
    ".TP\n2\nBad input: one line says where it is, what is wrong, and how to mend it.\n"
    ".TP\n130\nInterrupted, with the picture so far written, if there is one.\n";

/// Text that roff prints as it is.
std::string roff(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '\\') {
            safe += "\\e";
        } else if (c == '-') {
            safe += "\\-";
        } else {
            safe += c;
        }
    }
    return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

/// Of a form, words that stand for something are in italics, literal ones as they are.
std::string value_text(const CommandFlag& flag) {
    return is_literal(flag.form) ? roff(flag.form) : "\\fI" + roff(flag.form) + "\\fR";
}

void add_flag_entry(const CommandFlag& flag, bool has_dashes, std::string& page) {
    std::vector<std::string> names;
    for (const std::string& name : flag.names)
        names.push_back((has_dashes ? "\\fB" : "\\fI") + roff(name) + "\\fR");
    page += fmt::format(".TP\n{}", fmt::join(names, ", "));
    if (has_dashes && !flag.form.empty()) page += " " + value_text(flag);
    page += "\n" + roff(flag.help) + ".\n";
}

/// The flags under the headings of their groups.
void add_flags(const Command& command, std::string& page) {
    std::vector<std::string> groups;
    for (const CommandFlag& flag : command.flags)
        if (std::find(groups.begin(), groups.end(), flag.group) == groups.end())
            groups.push_back(flag.group);
    page += ".SH OPTIONS\n";
    for (const std::string& group : groups) {
        if (group != groups.front()) page += ".SS " + roff(group) + "\n";
        for (const CommandFlag& flag : command.flags)
            if (flag.group == group) add_flag_entry(flag, true, page);
    }
}

std::string title(const std::string& page_name, const std::string& help) {
    std::string upper = page_name;
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return fmt::format(".TH {} 1 \"\" \"sunfleck {}\" \"Sunfleck\"\n.SH NAME\n{} \\- {}\n",
                       roff(upper), SUNFLECK_VERSION, roff(page_name), roff(help));
}

std::string see_also(const Command& program, const std::string& but) {
    std::vector<std::string> pages;
    if (!but.empty()) pages.push_back(".BR " + program.name + " (1)");
    for (const Command& command : program.commands)
        if (command.name != but)
            pages.push_back(fmt::format(".BR {}\\-{} (1)", program.name, command.name));
    return fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, ",\n"));
}

}  // namespace

std::string man_page(const Command& program) {
    std::string page = title(program.name, program.help);
    page += fmt::format(".SH SYNOPSIS\n.B {0}\n\\fICOMMAND\\fR ...\n", program.name);
    page += ".SH COMMANDS\n";
    for (const Command& command : program.commands)
        page += fmt::format(".TP\n.BR {}\\-{} (1)\n{}.\n", program.name, command.name,
                            roff(command.help));
    add_flags(program, page);
    return page + kExitCodes + see_also(program, "");
}

std::string man_page(const Command& program, const Command& command) {
    std::string page = title(program.name + "-" + command.name, command.help);
    page += fmt::format(".SH SYNOPSIS\n.B {} {}\n[\\fIOPTIONS\\fR]", program.name, command.name);
    for (const CommandFlag& word : command.words) {
        const std::string text =
            "\\fI" + roff(word.names.front()) + "\\fR" + (word.repeats ? "..." : "");
        page += word.is_required ? " " + text : " [" + text + "]";
    }
    page += "\n.SH ARGUMENTS\n";
    for (const CommandFlag& word : command.words) add_flag_entry(word, false, page);
    add_flags(command, page);
    if (!command.examples.empty()) {
        page += ".SH EXAMPLES\n.nf\n";
        for (const std::string& line : command.examples) page += roff(line) + "\n";
        page += ".fi\n";
    }
    return page + kExitCodes + see_also(program, command.name);
}

}  // namespace sunfleck::engine
