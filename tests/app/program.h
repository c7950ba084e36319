// The built program as a process: run to its end, or left running and sent signals.
#pragma once

#include "image/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace sunfleck::engine::testing_support {

using Words = std::vector<std::string>;

inline Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

inline std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// How a process ended, and what it said.
struct Ran {
    int code = -1;  // exit code; 1000 + signal when one killed it
    std::string out;
    std::string err;
};

/// A process under way. Its output goes to files of `folder`.
class Process {
public:
    Process(const std::string& folder, const Words& words,
            const std::string& program = SUNFLECK_PROGRAM)
        : out_(folder + "/stdout~"), err_(folder + "/stderr~") {
        std::vector<std::string> all = Words{program} + words;
        std::vector<char*> argv;
        argv.reserve(all.size() + 1);
        for (std::string& word : all) argv.push_back(word.data());
        argv.push_back(nullptr);
        std::fflush(nullptr);  // or the child writes once more what is held back
        pid_ = ::fork();
        if (pid_ != 0) return;
        // Whoever runs the tests may ignore them.
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
        const bool open = std::freopen(out_.c_str(), "wb", stdout) != nullptr &&
                          std::freopen(err_.c_str(), "wb", stderr) != nullptr &&
                          ::chdir(folder.c_str()) == 0;
        if (open) ::execv(program.c_str(), argv.data());
        ::_exit(99);
    }

    void send(int signal) const { ::kill(pid_, signal); }
    ::pid_t id() const { return pid_; }

    /// Waits until the process catches SIGHUP, the last of the signals that it minds, as a render
    /// does that reads its scene. False when it never does.
    bool wait_for_handler() const {
        using namespace std::chrono_literals;
        for (int i = 0; i < 6000; ++i, std::this_thread::sleep_for(10ms)) {
            std::istringstream status(read_text("/proc/" + std::to_string(pid_) + "/status"));
            for (std::string line; std::getline(status, line);)
                if (line.starts_with("SigCgt:") &&
                    (std::stoull(line.substr(7), nullptr, 16) >> (SIGHUP - 1U) & 1U) != 0)
                    return true;
        }
        return false;
    }

    Ran wait() {
        int status = 0;
        ::waitpid(pid_, &status, 0);
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
        Ran ran{code, read_text(out_), read_text(err_)};
        std::filesystem::remove(out_);
        std::filesystem::remove(err_);
        return ran;
    }

private:
    std::string out_;
    std::string err_;
    ::pid_t pid_ = 0;
};

/// Tests that run the program in a folder of their own, which holds room.pbrt.
class ProgramTest : public TemporaryFolder {
protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        write_text(path("room.pbrt"), room_text("0.6"));
    }

    Ran run(const Words& words) const { return Process(path(""), words).wait(); }

    /// A render of room.pbrt with these words, of few photons if they do not say how many.
    Ran render(const Words& words) const {
        const bool no_count = std::any_of(words.begin(), words.end(), [](const std::string& word) {
            return word == "--photons-per-pass" || word == "path" || word == "bdpt" ||
                   word == "mlt";
        });
        const Words count = no_count ? Words{} : Words{"--photons-per-pass", "2000"};
        return run(Words{"render", "room.pbrt"} + count + words);
    }

    nlohmann::json json(const std::string& name) const {
        return nlohmann::json::parse(read_text(path(name)));
    }

    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

    /// Whether a file is half-written: the claims on outputs that stand beside it are empty.
    bool is_writing() const {
        return any_part([](std::uintmax_t size) { return size > 0; });
    }

    /// Waits until a render has read its scene: from then on it claims its outputs. False when it
    /// never does. (It tries them before, too, for an instant.)
    bool wait_for_render() const {
        using namespace std::chrono_literals;
        int seen = 0;
        for (int i = 0; i < 6000 && seen < 2; ++i, std::this_thread::sleep_for(10ms))
            seen = any_part([](std::uintmax_t size) { return size == 0; }) ? seen + 1 : 0;
        return seen == 2;
    }

    /// Names in the folder, but for the scene.
    std::string names() const {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(path("")))
            if (entry.path().extension() != ".pbrt") all.push_back(entry.path().filename());
        std::sort(all.begin(), all.end());
        std::string text;
        for (const std::string& name : all) text += (text.empty() ? "" : " ") + name;
        return text;
    }

    /// A closed box with a lamp, a glass ball and a picture of 16 x 12 pixels.
    static std::string room_text(const std::string& albedo) {
        return R"(LookAt 0 -0.9 0  0 1 -0.3  0 0 1
Film "rgb" "integer xresolution" 16 "integer yresolution" 12 "string filename" "named.exr"
Camera "perspective" "float fov" 70
Integrator "sppm" "integer maxdepth" 10
WorldBegin
Material "diffuse" "rgb reflectance" [)" +
               albedo + " 0.5 0.4]" + R"(
Shape "trianglemesh" "point3 P" [-1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1  -1 -1 1  1 -1 1  1 1 1  -1 1 1]
  "integer indices" [0 1 2 0 2 3  4 6 5 4 7 6  0 4 5 0 5 1  3 2 6 3 6 7  0 3 7 0 7 4  1 5 6 1 6 2]
AttributeBegin
AreaLightSource "diffuse" "rgb L" [5 5 5]
Shape "trianglemesh" "point3 P" [-0.4 -0.4 0.9  0.4 -0.4 0.9  0.4 0.4 0.9  -0.4 0.4 0.9]
  "integer indices" [0 2 1 0 3 2]
AttributeEnd
Translate 0.2 0.3 -0.6
Material "dielectric" "float eta" 1.5
Shape "sphere" "float radius" 0.3
)";
    }

private:
    /// Is there a temporary file of such a size?
    bool any_part(bool (*is_size)(std::uintmax_t)) const {
        std::error_code code;
        for (const auto& entry : std::filesystem::directory_iterator(path("")))
            if (const auto size = entry.file_size(code);
                !code && entry.path().extension() == ".part" && is_size(size))
                return true;
        return false;
    }
};

}  // namespace sunfleck::engine::testing_support
