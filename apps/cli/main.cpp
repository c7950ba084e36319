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
#include "image/atomic_file.h"

#include <unistd.h>

#include <csignal>
#include <exception>
#include <string_view>

namespace sunfleck::engine {
namespace {

int run(int count, char** words, const Ranks& ranks) {
    const auto options = together(ranks, [&] { return read_options(count, words); });
    if (!options) return 0;
    if (options->render) return run_render(*options->render, ranks);
    if (options->info) return run_info(*options->info);
    if (options->scene) return run_scene(*options->scene);
    if (options->convert) return run_convert(*options->convert);
    if (options->merge) return run_merge(*options->merge);
    if (options->relight) return run_relight(*options->relight);
    if (options->experiment) return run_experiment(*options->experiment);
    if (options->view) return run_view(*options->view);
    return run_compare(*options->compare);
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
    say(std::string("sunfleck: ") + what);
    remove_own_temporaries();
    _exit(1);
}

/// Leaves no temporary file, and ends by the signal as ever.
void end_by_signal(int signal) {
    remove_own_temporaries();
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
int fail(const Job& job, int code, const std::string& line) {
    say(line);
    job.abort(code);
    return code;
}

int run_program(int count, char** words) {
    keep_streams();
    const bool is_render = count > 1 && std::string_view(words[1]) == "render";
    set_ends(is_render);
    keep_freed_memory();
    const Job job(is_render);
    try {
        int code = 0;
        print_all([&] { code = run(count, words, job.ranks()); });
        return code;
    } catch (const FaultOfAll& fault) {
        if (job.ranks().is_first()) say(fault.what());
        return fault.code();
    } catch (const Error& error) {
        return fail(job, error.code() == ErrorCode::machine ? 1 : 2, error.what());
    } catch (const std::exception& error) {
        return fail(job, 1, std::string("sunfleck: ") + error.what());
    }
}

}  // namespace
}  // namespace sunfleck::engine

int main(int count, char** words) {
    return sunfleck::engine::run_program(count, words);
}
