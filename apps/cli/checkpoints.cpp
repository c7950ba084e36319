// Checkpoints of `sunfleck render`: tried before the work, written while it goes on.
#include "apps/cli/checkpoints.h"

#include "apps/cli/interrupt.h"

#include <filesystem>

namespace sunfleck::engine {

std::optional<Checkpoint> open_checkpoints(const RenderOptions& options) {
    namespace fs = std::filesystem;
    const std::string& file = options.checkpoint;
    std::error_code code;
    if (!file.empty()) {
        if (fs::exists(file, code) &&
            (options.resume.empty() || !fs::equivalent(file, options.resume, code)))
            throw Error({file}, "this file exists, and --checkpoint would replace it",
                        "go on from it with --resume " + file + ", or remove it");
    }
    if (options.resume.empty()) return {};
    return read_checkpoint(options.resume);
}

void CheckpointKeeper::save(const Origin& origin, const RenderState& state) {
    InterruptGuard::finish_first([&] {
        const auto write = [&] { write_checkpoint(options_.checkpoint, origin, state); };
        if (fault_.attempt(write)) fault_.forget();
    });
}

}  // namespace sunfleck::engine
