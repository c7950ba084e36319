// Help, man pages and completion say the same: all are made from the flags that the program has.
#include "app/program.h"

#include <map>
#include <regex>
#include <set>

namespace sunfleck::engine {
namespace {

using testing_support::Process;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;
using testing_support::write_text;

const Words kCommands = {"render", "info",    "scene",      "merge",      "relight",
                         "view",   "compare", "experiment", "completion", "manual"};

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
    return parts;
}

class Manual : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        const Ran ran = run({"manual", "share"});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }

    std::string man_page(const std::string& command) const {
        return read_text(path("share/man/man1/sunfleck-" + command + ".1"));
    }

    /// Each flag of a command's help, by any of its names, with what it takes: "on|off", "N".
    std::map<std::string, std::string> flags_of(const std::string& command) const {
        const std::regex row("^  (-[^ ]*) ?([^ ]*)");
        std::map<std::string, std::string> flags;
        for (const std::string& line : parts_of(run({command, "--help"}).out, '\n'))
            if (std::smatch match; std::regex_search(line, match, row))
                for (const std::string& name : parts_of(match[1], ',')) flags[name] = match[2];
        return flags;
    }

    /// What bash offers for the last of these words.
    std::string completed(const Words& words) const {
        std::string line;
        for (const std::string& word : words) line += " '" + word + "'";
        write_text(path("ask.sh"),
                   "source share/bash-completion/completions/sunfleck\nCOMP_WORDS=(" + line +
                       ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
                       "\n_sunfleck\necho \"${COMPREPLY[*]}\"\n");
        const Ran ran = Process(path(""), {"ask.sh"}, "/bin/bash").wait();
        EXPECT_EQ(ran.code, 0);
        EXPECT_EQ(ran.err, "");
        return ran.out.substr(0, ran.out.find('\n'));
    }

    /// What a program says of a file that it is to check; skips where there is no such program.
    std::string fault_by(const std::string& program, const Words& words) const {
        const Ran ran = Process(path(""), words, program).wait();
        return ran.code == 0 ? ran.err : "exit code " + std::to_string(ran.code) + ran.err;
    }
};

TEST_F(Manual, has_each_flag_of_each_command_everywhere) {
    const std::string bash = read_text(path("share/bash-completion/completions/sunfleck"));
    const std::string zsh = read_text(path("share/zsh/site-functions/_sunfleck"));
    const std::string fish = read_text(path("share/fish/vendor_completions.d/sunfleck.fish"));
    for (const std::string& command : kCommands) {
        const std::string page = std::regex_replace(man_page(command), std::regex("\\\\-"), "-");
        const std::string offered = " " + completed({"sunfleck", command, "-"}) + " ";
        const auto flags = flags_of(command);
        EXPECT_TRUE(flags.contains("--help")) << command;
        for (const auto& [name, form] : flags) {
            EXPECT_NE(page.find("\\fB" + name + "\\fR"), std::string::npos) << command << name;
            EXPECT_NE(offered.find(" " + name + " "), std::string::npos) << command << name;
            const std::string bare = name.substr(name.find_first_not_of('-'));
            const std::string in_fish = (name.starts_with("--") ? " -l " : " -s ") + bare + " ";
            EXPECT_NE(zsh.find(name), std::string::npos) << name;
            EXPECT_NE(fish.find(in_fish), std::string::npos) << name;
        }
    }
    EXPECT_GT(flags_of("render").size(), 50U);
    const std::string example = "sunfleck render scene.pbrt \\-o scene.exr";
    EXPECT_NE(man_page("render").find(example), std::string::npos);
}

TEST_F(Manual, completes_each_choice_of_each_flag) {
    int choices = 0;
    for (const std::string& command : kCommands)
        for (const auto& [name, form] : flags_of(command)) {
            std::string expected;
            for (const std::string& word : parts_of(form, '|'))
                if (std::none_of(word.begin(), word.end(), ::isupper))
                    expected += (expected.empty() ? "" : " ") + word;
            if (expected.empty()) continue;
            EXPECT_EQ(completed({"sunfleck", command, name, ""}), expected) << name;
            ++choices;
        }
    EXPECT_GT(choices, 15);
}

TEST_F(Manual, bash_completes_what_is_begun) {
    EXPECT_EQ(completed({"sunfleck", "re"}), "render relight");
    EXPECT_EQ(completed({"sunfleck", "--v"}), "--version");
    EXPECT_EQ(completed({"sunfleck", "render", "a.pbrt", "--photon-sampler", "=", "p"}), "paper");
    EXPECT_EQ(completed({"sunfleck", "render", "--aovs", "depth,c"}), "depth,caustic");
    EXPECT_EQ(completed({"sunfleck", "completion", ""}), "bash zsh fish");
    EXPECT_EQ(completed({"sunfleck", "scene", "cognac-4"}), "cognac-4");
    EXPECT_EQ(completed({"sunfleck", "render", "--passes", ""}), "");
}

TEST_F(Manual, needs_a_folder_that_can_be) {
    EXPECT_EQ(run({"manual", ""}).code, 2);
    write_text(path("file"), "");
    const Ran ran = run({"manual", "file"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("cannot be made"), std::string::npos) << ran.err;
}

TEST_F(Manual, is_printed_for_each_shell) {
    for (const auto& [shell, file] : {std::pair("bash", "bash-completion/completions/sunfleck"),
                                      std::pair("zsh", "zsh/site-functions/_sunfleck"),
                                      std::pair("fish", "fish/vendor_completions.d/sunfleck.fish")})
        EXPECT_EQ(run({"completion", shell}).out, read_text(path("share/") + file));
    const Ran ran = run({"completion", "tcsh"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("use bash|zsh|fish"), std::string::npos) << ran.err;
    EXPECT_EQ(run({"manual", "room.pbrt"}).code, 2) << "a file is no folder";
}

TEST_F(Manual, is_valid_to_man_and_the_shells_that_are_here) {
    const std::vector<Words> checks = {
        {"/usr/bin/man", "--warnings", "-l", "share/man/man1/sunfleck-render.1"},
        {"/usr/bin/man", "--warnings", "-l", "share/man/man1/sunfleck.1"},
        {"/usr/bin/zsh", "-n", "share/zsh/site-functions/_sunfleck"},
        {"/usr/bin/fish", "--no-execute", "share/fish/vendor_completions.d/sunfleck.fish"}};
    int made = 0;
    for (const Words& check : checks) {
        if (!std::filesystem::exists(check[0])) continue;
        EXPECT_EQ(fault_by(check[0], {check.begin() + 1, check.end()}), "") << check.back();
        ++made;
    }
    if (made == 0) GTEST_SKIP() << "neither man, zsh nor fish is here";
}

}  // namespace
}  // namespace sunfleck::engine
