// The program `sunfleck`: reads the command line, runs one command, turns faults into exit codes.
//
// 0 done; 1 a fault of ours or of the machine; 2 bad input or usage; 130 interrupted (with the
// picture so far written).
#include "apps/cli/commands.h"
#include "core/error.h"

#include <cstdio>
#include <exception>
#include <new>

namespace {

int run(int count, char** words) {
    const auto options = sunfleck::read_options(count, words);
    if (!options) return 0;
    if (options->render) return sunfleck::run_render(*options->render);
    if (options->info) return sunfleck::run_info(*options->info);
    if (options->scene) return sunfleck::run_scene(*options->scene);
    if (options->merge) return sunfleck::run_merge(*options->merge);
    if (options->experiment) return sunfleck::run_experiment(*options->experiment);
    return sunfleck::run_compare(*options->compare);
}

}  // namespace

int main(int count, char** words) {
    try {
        return run(count, words);
    } catch (const sunfleck::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "sunfleck: not enough memory\n");
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sunfleck: %s\n", error.what());
        return 1;
    }
}
