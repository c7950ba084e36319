// What every benchmark's main() ends with.
#pragma once

#include "core/kept_memory.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace sunfleck::engine::bench {

/// Reads the command line and does the work. @return the program's exit code: 2, after one line,
/// for words or files that cannot be used.
template <class Work>
int run_program(CLI::App& app, int count, char** words, const Work& work) {
    keep_freed_memory();
    try {
        app.parse(count, words);
        work();
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const sunfleck::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}

}  // namespace sunfleck::engine::bench
