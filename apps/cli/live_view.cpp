// The page's texts and pictures, from the thread that renders.
#include "apps/cli/live_view.h"

#include "apps/cli/interrupt.h"
#include "apps/cli/messages.h"
#include "camera/camera_move.h"
#include "film/film_picture.h"
#include "film/relight.h"
#include "image/exr.h"
#include "light/lumens.h"
#include "live/layers.h"
#include "math/white_balance.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration): not every system declares it

namespace sunfleck::engine {
namespace {

/// Ends the render as Ctrl+C does, once: a second signal would lose it.
std::function<void()> stop_once() {
    return [is_asked = std::make_shared<std::atomic<bool>>(false)] {
        if (!is_asked->exchange(true)) ::kill(::getpid(), SIGINT);
    };
}

/// Opens an address by the desktop's own choice of a browser.
void open_in_browser(const std::string& url, LogLevel log) {
    std::string program = "xdg-open";
    std::string address = url;
    const std::array<char*, 3> words{program.data(), address.data(), nullptr};
    ::posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    for (const int stream : {1, 2})
        ::posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_WRONLY, 0);
    ::pid_t child = 0;
    const int fault =
        ::posix_spawnp(&child, program.c_str(), &files, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (fault != 0 && log != LogLevel::quiet)
        say("warning: there is no xdg-open; open the address above yourself");
}

}  // namespace

LiveView::LiveView(LiveViewing viewing)
    : viewing_(std::move(viewing)),
      board_(std::make_shared<LiveBoard>()),
      wishes_(std::make_shared<LiveWishes>()),
      server_(board_, wishes_, viewing_.host, stop_once()) {
    status_.scene = viewing_.name;
    status_.tone = viewing_.transform.tone;
    if (viewing_.transform.white_balance)
        status_.balance = white_balance(*viewing_.transform.white_balance);
    if (!viewing_.earlier.empty()) {
        status_.earlier = std::filesystem::path(viewing_.earlier).filename().string();
        status_.earlier_picture = put_up(read_exr(viewing_.earlier), LivePlace::earlier, false);
    }
    tell();
    const std::string url = server_.url();
    if (viewing_.log != LogLevel::quiet) say(url);
    if (!viewing_.host.empty() && viewing_.log != LogLevel::quiet)
        say("warning: what is served at " + viewing_.host +
            " is not encrypted: whoever reads the network can look at the render and end it");
    if (viewing_.opens) open_in_browser(url, viewing_.log);
}

void LiveView::begin(const RenderSetup& setup, const std::vector<std::string>& warnings,
                     const Film* earlier) {
    const FilmKey key = key_of(setup.job);
    status_.width = key.width;
    status_.height = key.height;
    status_.nits = kLumensPerWatt / static_cast<double>(setup.scene.film().imaging_ratio);
    status_.has_lens = has_lens(setup.scene.camera());
    status_.ends = {setup.job.stop.target_error, setup.job.stop.seconds};
    status_.warnings = warnings;
    status_.stage = LiveStage::rendering;
    if (earlier != nullptr) show(*earlier);
    tell();
}

void LiveView::report(const Progress& progress) {
    // A run that goes on after a look aside knows the error again at the end of a batch.
    const std::optional<TargetError> before = status_.progress.error;
    status_.progress = progress;
    if (!progress.error) status_.progress.error = before;
    status_.stage = progress.is_learning ? LiveStage::learning : LiveStage::rendering;
    tell();
}

void LiveView::preview(Picture picture) {
    status_.picture = put_up(std::move(picture), LivePlace::render, true);
    tell();
}

void LiveView::show(const Film& film) {
    if (status_.picture.number > 0 && !status_.picture.is_preview && !pacing_.is_due()) return;
    pacing_.run([&] { status_.picture = picture_of(film, LivePlace::render); });
    shown_passes_ = film.pass_count();
    tell();
}

void LiveView::show_last(const RenderState& result) {
    if (result.film.pass_count() == shown_passes_) return;
    status_.picture = picture_of(result.film, LivePlace::render);
    shown_passes_ = result.film.pass_count();
    tell();
}

void LiveView::show_finished(Picture picture) {
    status_.width = picture.width;
    status_.height = picture.height;
    status_.picture = put_up(std::move(picture), LivePlace::render, false);
}

LivePicture LiveView::picture_of(const Film& film, LivePlace place) {
    return put_up(film_picture(film, {viewing_.extrapolates}), place, false);
}

LivePicture LiveView::put_up(Picture picture, LivePlace place, bool is_preview) {
    if (place == LivePlace::render) status_.exposure = stops_of(viewing_.exposure, picture);
    LivePicture shown{.groups = light_groups_of(picture), .is_preview = is_preview};
    for (const LiveLayer& layer : layers_of(picture)) shown.layers.push_back(layer.name);
    shown.number = board_->show(std::move(picture), place);
    return shown;
}

void LiveView::end(const std::vector<std::string>& warnings,
                   const std::function<void()>& meanwhile) {
    status_.warnings = warnings;
    status_.stage = LiveStage::ended;
    tell();
    if (!viewing_.stays || InterruptGuard::interrupted()) return;
    static constexpr InterruptAnswer kNothingIsLost{};
    InterruptGuard::set_answer(kNothingIsLost);
    constexpr std::chrono::milliseconds kTick(50);
    while (!InterruptGuard::interrupted()) {
        if (wishes_->wants_change())
            meanwhile();
        else
            std::this_thread::sleep_for(kTick);
    }
}

void LiveView::accept_wishes() {
    wishes_->accept();
    status_.can_be_steered = true;
    tell();
}

void LiveView::set_paused(bool is_paused) {
    if (status_.is_paused == is_paused) return;
    status_.is_paused = is_paused;
    tell();
}

void LiveView::set_ends(const LiveEnds& ends) {
    status_.ends = ends;
    tell();
}

void LiveView::begin_look(const LiveLook& look) {
    // What was seen of the region stays until there is more to see.
    const bool is_same = status_.look && status_.look->region == look.region;
    const LivePicture before = is_same ? status_.look->picture : LivePicture();
    status_.look = look;
    status_.look->picture = before;
    look_pacing_ = {};
    tell();
}

void LiveView::report_look(const Progress& progress) {
    status_.look->progress = progress;
    tell();
}

void LiveView::sketch_look(Picture picture) {
    status_.look->picture = put_up(std::move(picture), LivePlace::look, true);
    tell();
}

void LiveView::show_look(const Film& film) {
    if (!look_pacing_.is_due()) return;
    look_pacing_.run([&] { status_.look->picture = picture_of(film, LivePlace::look); });
    tell();
}

void LiveView::fail_look(const std::string& fault) {
    status_.look->fault = fault;
    tell();
}

void LiveView::end_look() {
    status_.look.reset();
    board_->clear(LivePlace::look);
    tell();
}

}  // namespace sunfleck::engine
