// Runs of the render, and looks aside between them.
#include "apps/cli/steered_render.h"

#include "apps/cli/interrupt.h"
#include "apps/cli/look_aside.h"
#include "core/stopwatch.h"
#include "render/render_loop.h"

#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr std::chrono::milliseconds kTick(20);
constexpr double kSecondsAlone = 30;  // then a look that nobody watches ends

/// Waits while `is_waiting()`, but for a signal no longer.
template <class Condition>
void wait_while(const Condition& is_waiting) {
    while (is_waiting() && !InterruptGuard::interrupted()) std::this_thread::sleep_for(kTick);
}

/// Ends a look whose viewers have gone: the render waits for it.
class Abandoned {
public:
    explicit Abandoned(LiveView& view) : view_(view) {}

    void ask() {
        if (view_.watching() > 0) alone_ = {};
        if (alone_.seconds() > kSecondsAlone) view_.wishes().end_look();
    }

private:
    LiveView& view_;
    Stopwatch alone_;
};

void pause(LiveView& view, const std::function<void()>& meanwhile = {}) {
    const LiveWishes& wishes = view.wishes();
    view.set_paused(wishes.is_paused());
    wait_while([&] {
        if (meanwhile) meanwhile();
        return wishes.is_paused() && !wishes.wants_change() && !wishes.wants_other_ends();
    });
    view.set_paused(wishes.is_paused());
}

RenderHooks hooks_of_look(LiveView& view, Abandoned& abandoned) {
    RenderHooks hooks;
    hooks.report = [&](const Progress& progress) { view.report_look(progress); };
    hooks.watch = [&](const Film& film) { view.show_look(film); };
    hooks.goes_on = [&] {
        abandoned.ask();
        pause(view, [&] { abandoned.ask(); });
        return true;
    };
    hooks.interrupted = &InterruptGuard::interrupted();
    hooks.cancelled = &view.wishes().wants_change();
    return hooks;
}

void render_look(const RenderSetup& setup, const Look& look, LiveView& view) {
    Abandoned abandoned(view);
    try {
        LookAside aside(setup, look);
        view.begin_look({.region = aside.region(),
                         .is_moved = look.move != CameraMove() || look.focus.has_value(),
                         .camera = aside.camera_text()});
        if (look.is_moving)
            view.sketch_look(aside.sketch(view.exposure()));
        else
            aside.run(hooks_of_look(view, abandoned));
    } catch (const std::exception& fault) {  // too little memory, too: the render goes on
        view.begin_look({});
        view.fail_look(fault.what());
    }
    wait_while([&] {
        abandoned.ask();
        view.set_paused(view.wishes().is_paused());
        return !view.wishes().wants_change();
    });
}

}  // namespace

void look_aside(const RenderSetup& setup, LiveView& view) {
    while (const auto look = view.wishes().take_look()) {
        render_look(setup, *look, view);
        if (InterruptGuard::interrupted()) break;
    }
    view.end_look();
}

RenderResult render_steered(RenderSetup& setup, RenderHooks hooks,
                            std::optional<RenderState> earlier, LiveView& view) {
    LiveWishes& wishes = view.wishes();
    hooks.cancelled = &wishes.wants_change();
    hooks.goes_on = [&] {
        pause(view);
        return !wishes.wants_other_ends();
    };
    view.accept_wishes();
    RenderLoop loop(setup.job, std::move(earlier));
    while (true) {
        loop.run(setup.job.stop, hooks);
        if (InterruptGuard::interrupted()) break;
        if (wishes.wants_change()) {
            look_aside(setup, view);
        } else if (const auto ends = wishes.take_ends()) {
            StopSettings& stop = setup.job.stop;
            stop.target_error = ends->error;
            stop.seconds = ends->seconds;
            stop.cpu_seconds.reset();
            view.set_ends(*ends);
        } else {
            break;
        }
    }
    return loop.take();
}

}  // namespace sunfleck::engine
