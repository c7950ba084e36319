// The program `sunfleck`: reads the command line, runs one command, turns faults into exit codes.
//
// 0 done; 1 a fault of ours or of the machine; 2 bad input or usage; 130 interrupted (with the
// picture so far written). Of several ranks rank 0 has the code of all; others that go well 0.
#include "apps/cli/command_line.h"
#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "apps/cli/together.h"
#include "apps/mpi/job.h"
#include "core/kept_memory.h"
#include "core/machine_fault.h"
#include "image/atomic_file.h"

#include <unistd.h>

#include <csignal>
#include <exception>
#include <string_view>

namespace {

using sunfleck::engine::Ranks;

int run(int count, char** words, const Ranks& ranks) {
    const auto options = sunfleck::engine::together(
        ranks, [&] { return sunfleck::engine::read_options(count, words); });
    if (!options) return 0;
    if (options->render) return sunfleck::engine::run_render(*options->render, ranks);
    if (options->info) return sunfleck::engine::run_info(*options->info);
    if (options->scene) return sunfleck::engine::run_scene(*options->scene);
    if (options->merge) return sunfleck::engine::run_merge(*options->merge);
    if (options->relight) return sunfleck::engine::run_relight(*options->relight);
    if (options->experiment) return sunfleck::engine::run_experiment(*options->experiment);
    return sunfleck::engine::run_compare(*options->compare);
}

/// Ends the program in place of abort(): an exception that nobody can catch, as of a thread of a
/// library that has no memory left.
[[noreturn]] void end_by_fault() {
    const char* what = "a fault that has no name";
    try {
        if (const std::exception_ptr fault = std::current_exception())
            std::rethrow_exception(fault);
    } catch (const std::exception& error) {
        what = error.what();
    }
    sunfleck::engine::say(std::string("sunfleck: ") + what);
    sunfleck::engine::remove_own_temporaries();
    _exit(1);
}

/// Leaves no temporary file, and ends by the signal as ever.
void end_by_signal(int signal) {
    sunfleck::engine::remove_own_temporaries();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// @param is_render  which has files under way only where it answers signals itself.
void set_ends(bool is_render) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is a fault as any other
    std::set_terminate(end_by_fault);
    if (is_render) return;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, end_by_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
}

/// @return code, where it returns.
int fail(const sunfleck::engine::Job& job, int code, const std::string& line) {
    sunfleck::engine::say(line);
    job.abort(code);
    return code;
}

}  // namespace

int main(int count, char** words) {
    sunfleck::engine::keep_streams();
    const bool is_render = count > 1 && std::string_view(words[1]) == "render";
    set_ends(is_render);
    sunfleck::engine::keep_freed_memory();
    const sunfleck::engine::Job job(is_render);
    try {
        int code = 0;
        sunfleck::engine::print_all([&] { code = run(count, words, job.ranks()); });
        return code;
    } catch (const sunfleck::engine::FaultOfAll& fault) {
        if (job.ranks().is_first()) sunfleck::engine::say(fault.what());
        return fault.code();
    } catch (const sunfleck::engine::MachineFault& fault) {
        return fail(job, 1, fault.what());
    } catch (const sunfleck::Error& error) {
        return fail(job, 2, error.what());
    } catch (const std::exception& error) {
        return fail(job, 1, std::string("sunfleck: ") + error.what());
    }
}
