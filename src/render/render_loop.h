// The passes of a render on one machine, one after the other, each added to the film at once.
//
// In:  a job, earlier passes. Out: after each run() the film of all passes so far. What was learned
// for the passes of an epoch stays from one run() to the next.
#pragma once

#include "render/pass_maker.h"
#include "render/render_hooks.h"
#include "render/render_job.h"
#include "render/render_state.h"

#include <optional>
#include <utility>

namespace sunfleck::engine {

/// A render of this job before it goes on. @param earlier  passes so far; nothing: none.
RenderResult first_result(const RenderJob& job, std::optional<RenderState> earlier);

class RenderLoop {
public:
    /// @param earlier  as for render() (render/progressive.h).
    RenderLoop(const RenderJob& job, std::optional<RenderState> earlier);
    ~RenderLoop() = default;
    RenderLoop(const RenderLoop&) = delete;  // its parts refer to each other
    RenderLoop& operator=(const RenderLoop&) = delete;
    RenderLoop(RenderLoop&&) = delete;
    RenderLoop& operator=(RenderLoop&&) = delete;

    /// Renders passes until one of the limits. The seconds of earlier runs count.
    void run(const StopSettings& stop, const RenderHooks& hooks);

    const RenderResult& result() const { return result_; }
    /// The result, once no more is to be run.
    RenderResult take() { return std::move(result_); }

private:
    void leave_learning_out(const RenderHooks& hooks);

    RenderJob job_;
    RenderResult result_;
    std::optional<PassMaker> passes_;
};

}  // namespace sunfleck::engine
