// What is said at a first signal, and at a second one.
#include "apps/cli/render_answers.h"

namespace sunfleck::engine {
namespace {

constexpr InterruptAnswer kQuiet{};
constexpr InterruptAnswer kQuietEnd{.ends = true};
constexpr InterruptAnswer kReading{
    .first = "interrupted while reading the scene: no picture is written", .ends = true};
constexpr InterruptAnswer kReadingResumed{
    .first =
        "interrupted while reading the scene: no picture is written; the checkpoint "
        "stays as it was",
    .ends = true};
constexpr InterruptAnswer kLearning{
    .first = "interrupted before the first pass: no picture is written", .ends = true};
constexpr InterruptAnswer kFirstPass{
    .first =
        "finishing the first pass, then writing the picture; interrupt again to quit without it",
    .lost = "quit: no picture is written"};
constexpr InterruptAnswer kLaterPass{
    .first = "finishing this pass, then writing the picture; interrupt again to quit without it",
    .lost = "quit: the picture is lost"};
constexpr InterruptAnswer kLaterPassKept{
    .first = kLaterPass.first,
    .lost = "quit: the picture is lost, except for the passes in the checkpoint"};
constexpr InterruptAnswer kWriting{
    .first = "writing the files; interrupt again to quit without the rest",
    .lost = "quit: files that are not written yet are lost"};

}  // namespace

const InterruptAnswer& answer_while(RenderStep step, const RenderOptions& options) {
    if (options.log == LogLevel::quiet) return step <= RenderStep::learning ? kQuietEnd : kQuiet;
    switch (step) {
        case RenderStep::reading:
            return options.resume.empty() ? kReading : kReadingResumed;
        case RenderStep::learning:
            return kLearning;
        case RenderStep::first_pass:
            return kFirstPass;
        case RenderStep::later_pass:
            return options.checkpoint.empty() ? kLaterPass : kLaterPassKept;
        case RenderStep::writing:
            break;
    }
    return kWriting;
}

}  // namespace sunfleck::engine
