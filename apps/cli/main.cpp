// The program `sunfleck`: reads the command line, runs one command, turns faults into exit codes.
//
// 0 done; 1 a fault of ours or of the machine; 2 bad input or usage; 130 interrupted (with the
// picture so far written). Of several ranks rank 0 has the code of all; others that go well 0.
#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "apps/cli/together.h"
#include "apps/mpi/job.h"
#include "core/error.h"
#include "core/kept_memory.h"

#include <csignal>
#include <exception>
#include <new>
#include <string_view>

namespace {

using sunfleck::Ranks;

int run(int count, char** words, const Ranks& ranks) {
    const auto options =
        sunfleck::together(ranks, [&] { return sunfleck::read_options(count, words); });
    if (!options) return 0;
    if (options->render) return sunfleck::run_render(*options->render, ranks);
    if (options->info) return sunfleck::run_info(*options->info);
    if (options->scene) return sunfleck::run_scene(*options->scene);
    if (options->merge) return sunfleck::run_merge(*options->merge);
    if (options->relight) return sunfleck::run_relight(*options->relight);
    if (options->experiment) return sunfleck::run_experiment(*options->experiment);
    return sunfleck::run_compare(*options->compare);
}

/// @return code, where it returns.
int fail(const sunfleck::Job& job, int code, const std::string& line) {
    sunfleck::say(line);
    job.abort(code);
    return code;
}

}  // namespace

int main(int count, char** words) {
    sunfleck::keep_streams();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is a fault as any other
    sunfleck::keep_freed_memory();
    const sunfleck::Job job(count > 1 && std::string_view(words[1]) == "render");
    try {
        int code = 0;
        sunfleck::print_all([&] { code = run(count, words, job.ranks()); });
        return code;
    } catch (const sunfleck::FaultOfAll& fault) {
        if (job.ranks().is_first()) sunfleck::say(fault.what());
        return 2;
    } catch (const sunfleck::Error& error) {
        return fail(job, 2, error.what());
    } catch (const std::bad_alloc&) {
        return fail(job, 1, "sunfleck: not enough memory");
    } catch (const std::exception& error) {
        return fail(job, 1, std::string("sunfleck: ") + error.what());
    }
}
